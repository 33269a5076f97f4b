// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/StreamedWind.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/wind/Interpolation.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <algorithm>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t placesAtOnce = 64;

/// The grid without its values and times.
GridWind::Grid shapeOf(const GridWind::Grid& grid) {
    GridWind::Grid shape;
    shape.points = grid.points;
    shape.origin = grid.origin;
    shape.cell = grid.cell;
    shape.heights = grid.heights;
    return shape;
}

} // namespace

StreamedWind::StreamedWind(GridWind::Grid shape, Updates&& first)
    : _shape(std::move(shape)), _updates(std::make_shared<const Updates>(std::move(first))) {}

Result<std::shared_ptr<StreamedWind>> StreamedWind::create(GridWind::Grid grid) {
    if (grid.times.size() > 1)
        return keyProblem("times", "expected one time at most, found " + std::to_string(grid.times.size()));
    GridWind::Grid shape = shapeOf(grid);
    const std::vector<double> times = grid.times;
    const Result<GridPtr> first = GridWind::create(std::move(grid));
    if (!first)
        return first.problems();
    return std::shared_ptr<StreamedWind>(new StreamedWind(std::move(shape), {{first.value()}, times}));
}

Diagnostics StreamedWind::update(const Update& update) {
    const std::lock_guard<std::mutex> lock(_updating);
    const std::shared_ptr<const Updates> before = current();
    Updates updates;
    if (update.time) {
        const double earliest = before->times.empty() ? -maxTime : before->times.back();
        if (!(*update.time > earliest && *update.time <= maxTime))
            return {keyProblem("time", "expected seconds after " + numberText(earliest) +
                                           " and within 1e15, found " + numberText(*update.time))};
        if (!before->times.empty())
            updates = {{before->grids.back()}, {before->times.back()}};
        updates.times.push_back(*update.time);
    }
    GridWind::Grid next = shapeOf(_shape);
    next.origin = update.origin.value_or(before->grids.back()->grid().origin);
    for (float& height : next.heights)
        height += static_cast<float>(next.origin.z - _shape.origin.z);
    if (!update.velocities.data && update.velocities.size > 0)
        return {keyProblem("velocities", "expected numbers, found a null pointer")};
    next.values.assign(update.velocities.begin(), update.velocities.end());
    const Result<GridPtr> grid = GridWind::create(std::move(next));
    if (!grid)
        return grid.problems();
    updates.grids.push_back(grid.value());
    std::atomic_store(&_updates, std::make_shared<const Updates>(std::move(updates)));
    return {};
}

std::shared_ptr<const StreamedWind::Updates> StreamedWind::current() const {
    return std::atomic_load(&_updates);
}

glm::vec3 StreamedWind::velocity(const WindPlace& place, double time) const {
    glm::vec3 velocity(0.0f);
    sample(&place, 1, time, &velocity);
    return velocity;
}

void StreamedWind::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    const std::shared_ptr<const Updates> now = current();
    const Interpolation at = now->times.empty() ? Interpolation{} : interpolationAtTime(time, now->times);
    now->grids[at.lower]->sample(places, count, time, out);
    if (at.fraction == 0.0)
        return;
    glm::vec3 later[placesAtOnce];
    for (std::size_t first = 0; first < count; first += placesAtOnce) {
        const std::size_t some = std::min(placesAtOnce, count - first);
        now->grids[at.upper]->sample(places + first, some, time, later);
        for (std::size_t i = 0; i < some; ++i)
            out[first + i] = glm::vec3(at.mix(glm::dvec3(out[first + i]), glm::dvec3(later[i])));
    }
}

} // namespace osgTreeWind
