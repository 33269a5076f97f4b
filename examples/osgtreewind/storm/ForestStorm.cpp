// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/ForestStorm.h>

#include <examples/osgtreewind/storm/OpenCountry.h>
#include <osgTreeWind/base/Jobs.h>
#include <osgTreeWind/motion/MakeCanopyMap.h>
#include <osgTreeWind/wind/LayeredWind.h>

#include <glm/geometric.hpp>

namespace osgTreeWind {

namespace {

constexpr double step = 0.2, settling = 60.0, hour = 3600.0; // seconds

} // namespace

ForestStorm::ForestStorm(const PlacedForest& forest, const glm::vec3& toward, Executor executor,
                         std::size_t most)
    : _forest(forest), _toward(toward), _executor(executor) {
    std::vector<ModalTree> swaying;
    std::vector<CanopyTree> standing;
    for (std::size_t slot = 0; slot < forest.trees.size(); ++slot) {
        const PlacedTree& tree = forest.trees[slot];
        if (!tree.alive)
            continue;
        const TreeModel& model = forest.modelOf(tree);
        const Species& species = forest.speciesOf(tree);
        standing.emplace_back(forest, tree);
        if (slot >= most)
            continue;
        _slots.push_back(slot);
        swaying.push_back(makeModalTree(forest, tree, ModalLevel::Far));
        const TreeForm& form = swaying.back().form;
        const std::vector<UnitLoad> loads = makeUnitLoads(model, form.scale, species, form.leaves);
        _joints.push_back({{0, loads[0].stiffness, 0.0f}, thickestBoughs(form, loads)});
    }
    const CanopySettings& settings = forest.description().canopy;
    const std::shared_ptr<CanopyMap> canopy = makeCanopyMap(standing, settings);
    canopy->setReference(static_cast<float>(settings.reference));
    _canopy = canopy;
    auto resting = std::make_shared<ModalMotion>(swaying, 1.0f, std::move(executor));
    resting->stepFarTreesTogether();
    _resting = std::move(resting);
}

std::vector<ForestStorm::Loads> ForestStorm::largestLoads(double speed, std::uint32_t seed) const {
    const LayeredWind wind(
        std::make_shared<Wind>(openCountryWind(10.0, static_cast<float>(speed) * _toward, seed)),
        glm::dmat4(1.0), _canopy, seed);
    ModalMotion motion(*_resting);
    for (std::size_t i = 0; i < _slots.size(); ++i)
        motion.setNeighbourEffect(
            i, wind.canopy()->neighbourEffectAt(glm::vec2(_forest.trees[_slots[i]].position)));
    motion.sampleWind(&wind, 0.0);
    std::vector<float> leans(_slots.size(), 0.0f);
    std::vector<Loads> largest(_slots.size());
    const auto updateLargest = [&](std::size_t i) {
        const float lean = glm::length(motion.lean(i));
        if (lean < 0.8f * leans[i]) // moments are largest near the largest lean
            return;
        leans[i] = std::max(leans[i], lean);
        const ModalMotion::PoseVector vector = motion.poseVector(i);
        const auto momentAt = [&](const BreakableJoint& base) {
            return static_cast<double>(static_cast<float>(base.moment(motion, i, vector)));
        };
        largest[i].foot = std::max(largest[i].foot, momentAt(_joints[i].foot));
        for (const BreakableJoint& bough : _joints[i].boughs)
            if (bough.limit > 0.0f)
                largest[i].bough =
                    std::max(largest[i].bough, momentAt(bough) / static_cast<double>(bough.limit));
    };
    const int steps = static_cast<int>((settling + hour) / step);
    for (int i = 1; i <= steps; ++i) {
        motion.step(&wind, step * i, static_cast<float>(step));
        if (step * i > settling)
            runInBatches(_executor, _slots.size(), updateLargest);
    }
    std::vector<Loads> bySlot(_forest.trees.size());
    for (std::size_t i = 0; i < _slots.size(); ++i)
        bySlot[_slots[i]] = largest[i];
    return bySlot;
}

std::vector<float> ForestStorm::topWinds() const {
    std::vector<float> winds(_forest.trees.size(), 0.0f);
    const LogProfile open = openCountryProfile(10.0);
    for (const std::size_t slot : _slots) {
        const PlacedTree& tree = _forest.trees[slot];
        const CanopySample stand = _canopy->at(glm::vec2(tree.position - _canopy->fetch * _toward), 10.0f);
        const double above = open.factor(_canopy->reference) * static_cast<double>(stand.topSpeedRatio),
                     alone = open.factor(_forest.sizeOf(tree).height);
        winds[slot] = static_cast<float>(alone + static_cast<double>(stand.closure) * (above - alone));
    }
    return winds;
}

} // namespace osgTreeWind
