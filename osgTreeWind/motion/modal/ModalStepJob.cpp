// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalStepJob.h>

#include <osgTreeWind/base/ClampOr.h>
#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/wind/LayeredWind.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t lanes = TreeLanes::count;
constexpr std::size_t blocksPerJob = 4;
constexpr float longestNearStep = 1.0f / 30.0f; // seconds

} // namespace

/// Buffers of one job. A job takes its thread's buffers while it runs, since the thread may start another job
/// while it samples the wind.
struct ModalStepJob::Scratch {
    std::vector<WindPlace> places;
    std::vector<glm::vec3> winds;
    std::vector<TreeLanes> lanes;
};

bool ModalStepJob::validate() const {
    return state && turns > 0 && std::isfinite(time) && std::isfinite(seconds) && seconds >= 0.0f;
}

bool ModalStepJob::run() const {
    static const Executor alone = runInTurn;
    if (!validate())
        return false;
    planWork();
    const std::size_t blocks = state->work.size();
    runJobs(executor ? *executor : alone, (blocks + blocksPerJob - 1) / blocksPerJob, [&](std::size_t job) {
        thread_local Scratch kept;
        Scratch scratch = std::move(kept);
        advance(job * blocksPerJob, std::min(blocks, (job + 1) * blocksPerJob), scratch);
        kept = std::move(scratch);
    });
    return true;
}

/// Plans steps to `time` for near trees, and to their last fixed time for far ones.
void ModalStepJob::planWork() const {
    constexpr auto interval = static_cast<double>(farStep);
    const auto* layers = dynamic_cast<const LayeredWind*>(wind);
    state->work.clear();
    for (std::uint32_t g = 0; g < state->groups.size(); ++g) {
        ModalGroup& group = state->groups[g];
        group.keepStands(layers && layers->canopy());
        const bool far = group.level != 0;
        for (std::uint32_t b = 0; b < group.waiting.size(); ++b) {
            if (!(seconds > 0.0f)) {
                state->work.push_back({g, b, 0.0f, time});
                continue;
            }
            const double turn = interval * static_cast<double>((g / Archetype::levels + b) % turns) /
                                static_cast<double>(turns);
            const double to = far ? interval * std::floor((time - turn) / interval) + turn : time;
            // For times so large that a double does not resolve the interval, the difference is set to 0.
            const float late = clampOr(static_cast<float>(time - to), -farStep, farStep, 0.0f);
            const float waited = group.waiting[b] + seconds;
            const bool due = !far || waited - late > 0.01f * farStep; // otherwise already at `to`
            if (due)
                state->work.push_back({g, b, waited - late, to});
            group.waiting[b] = due ? late : waited;
        }
    }
}

void ModalStepJob::advance(std::size_t first, std::size_t end, Scratch& scratch) const {
    sampleWind(first, end, scratch);
    const glm::vec3* met = scratch.winds.data();
    for (std::size_t w = first; w < end; ++w) {
        const ModalState::Work& work = state->work[w];
        ModalGroup& group = state->groups[work.group];
        const ModalModel& model = group.model();
        const std::size_t patches = model.patches.size();
        const std::size_t trees = group.treesIn(work.block);
        scratch.lanes.assign(3 * patches, TreeLanes());
        for (std::size_t i = 0; i < trees; ++i)
            for (std::size_t p = 0; p < patches; ++p, ++met)
                for (std::size_t c = 0; c < 3; ++c)
                    scratch.lanes[3 * p + c].tree[i] = (*met)[static_cast<glm::length_t>(c)];
        ModalStep step;
        step.model = &model;
        step.block = group.block(work.block);
        step.wind = scratch.lanes.data();
        step.seconds = work.seconds;
        step.gain = state->gain;
        const float longest = group.level == 0 ? longestNearStep : farStep;
        step.substeps = std::max(step.seconds > 0.0f ? 1 : 0,
                                 static_cast<int>(std::ceil(step.seconds / longest - 0.01f)));
        stepTrees(step, instructions);
        for (std::size_t i = 0; i < trees; ++i)
            state->updateLean(group.trees[work.block * lanes + i]);
    }
}

/// Samples the wind at the patches of a range of blocks, at the time of each block.
void ModalStepJob::sampleWind(std::size_t first, std::size_t end, Scratch& scratch) const {
    const std::vector<ModalState::Work>& work = state->work;
    std::size_t count = 0;
    for (std::size_t w = first; w < end; ++w) {
        const ModalGroup& group = state->groups[work[w].group];
        count += group.treesIn(work[w].block) * group.model().patches.size();
    }
    if (scratch.places.size() < count) {
        scratch.places.resize(count);
        scratch.winds.resize(count);
    }
    if (!wind)
        std::fill_n(scratch.winds.begin(), count, glm::vec3(0.0f));
    WindPlace *next = scratch.places.data(), *sampled = next;
    for (std::size_t w = first; wind && w < end; ++w) {
        next = addPlaces(work[w], next);
        if (w + 1 < end && work[w + 1].time == work[w].time)
            continue;
        wind->sample(sampled, static_cast<std::size_t>(next - sampled), work[w].time,
                     scratch.winds.data() + (sampled - scratch.places.data()));
        sampled = next;
    }
}

/// Appends the wind places of the patches in a block, tree after tree. @return the end of the places.
WindPlace* ModalStepJob::addPlaces(const ModalState::Work& work, WindPlace* out) const {
    ModalGroup& group = state->groups[work.group];
    const std::size_t factor = group.firstFactor(), trees = group.treesIn(work.block);
    const TreeLanes* numbers = group.block(work.block);
    PlaceInStand* stand =
        group.stands.empty() ? nullptr : &group.stands[work.block * lanes * group.model().patches.size()];
    for (std::size_t i = 0; i < trees; ++i) {
        const ModalState::Place& place = state->places[group.trees[work.block * lanes + i]];
        const float cosine = numbers[factor].tree[i], sine = numbers[factor + 1].tree[i];
        const glm::vec3 axes(place.width, place.width, numbers[factor + 2].tree[i]);
        for (const ModalModel::Patch& patch : group.model().patches) {
            const glm::vec3 at = axes * patch.place;
            *out = WindPlace(place.foot +
                                 glm::vec3(cosine * at.x - sine * at.y, sine * at.x + cosine * at.y, at.z),
                             place.foot.z);
            out->inCrown = true;
            out++->stand = stand ? stand++ : nullptr;
        }
    }
    return out;
}

} // namespace osgTreeWind
