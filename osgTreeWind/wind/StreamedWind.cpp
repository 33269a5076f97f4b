// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/StreamedWind.h>

#include <utility>

namespace osgTreeWind {

StreamedWind::StreamedWind(GridPtr grid) : _grid(std::move(grid)) {}

Result<std::shared_ptr<StreamedWind>> StreamedWind::create(GridWind::Grid grid) {
    if (grid.times.size() > 1)
        return Diagnostic{
            {}, 0, 0, "times", "expected one time at most, found " + std::to_string(grid.times.size())};
    Result<GridPtr> first = GridWind::create(std::move(grid));
    if (!first)
        return first.problems();
    return std::shared_ptr<StreamedWind>(new StreamedWind(first.value()));
}

Diagnostics StreamedWind::update(std::vector<float> values) {
    const GridPtr before = current();
    const GridWind::Grid& shape = before->grid();
    GridWind::Grid next;
    next.points = shape.points;
    next.origin = shape.origin;
    next.cell = shape.cell;
    next.times = shape.times;
    next.heights = shape.heights;
    next.values = std::move(values);
    Result<GridPtr> grid = GridWind::create(std::move(next));
    if (!grid)
        return grid.problems();
    std::atomic_store(&_grid, std::move(grid.value()));
    return {};
}

glm::vec3 StreamedWind::velocity(const WindPlace& place, double time) const {
    return current()->velocity(place, time);
}

void StreamedWind::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    current()->sample(places, count, time, out);
}

} // namespace osgTreeWind
