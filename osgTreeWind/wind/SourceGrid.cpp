// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/SourceGrid.h>

#include <osgTreeWind/wind/FiniteVelocity.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace osgTreeWind {

namespace {

/// Cell index along an axis; NaN gives the lowest cell.
std::int32_t cellAt(double coordinate, double size) {
    constexpr double last = 1e9;
    return static_cast<std::int32_t>(std::max(-last, std::min(std::floor(coordinate / size), last)));
}

std::uint64_t keyOf(std::int32_t x, std::int32_t y) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32 | static_cast<std::uint32_t>(y);
}

using Box = std::pair<glm::dvec2, glm::dvec2>;

/// Small enough that few sources share a cell, large enough that each source covers few cells.
double cellSize(const std::vector<Box>& boxes) {
    constexpr double meanCellsOfSource = 32.0, smallest = 1.0; // the latter in metres
    double size = std::numeric_limits<double>::infinity();
    for (const auto& [low, high] : boxes)
        size = std::min({size, high.x - low.x, high.y - low.y});
    size = std::max(size, smallest);
    const auto cells = [&] {
        double sum = 0.0;
        for (const auto& [low, high] : boxes)
            sum += ((high.x - low.x) / size + 1.0) * ((high.y - low.y) / size + 1.0);
        return sum;
    };
    while (cells() > meanCellsOfSource * static_cast<double>(boxes.size()))
        size *= 2.0;
    return size;
}

} // namespace

SourceGrid::SourceGrid(const std::vector<WindSource>& sources)
    : _flows(sources.begin(), sources.end()), _validFor(std::numeric_limits<double>::infinity()) {
    for (const SourceFlow& flow : _flows)
        _validFor = std::min(_validFor, std::max(flow.reachTravelTime(), 0.5));
    if (!isEmpty())
        _cells = cellsAround(0.0);
}

std::shared_ptr<const SourceGrid::Cells> SourceGrid::cellsAround(double time) const {
    auto cells = std::make_shared<Cells>();
    cells->_middle = time;
    cells->_validFor = _validFor;
    std::vector<Box> boxes;
    boxes.reserve(_flows.size());
    for (const SourceFlow& flow : _flows)
        boxes.push_back(flow.reachBounds(time, std::isfinite(_validFor) ? _validFor : 0.0));
    cells->_size = cellSize(boxes);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const auto& [low, high] = boxes[i];
        for (std::int32_t x = cellAt(low.x, cells->_size); x <= cellAt(high.x, cells->_size); ++x)
            for (std::int32_t y = cellAt(low.y, cells->_size); y <= cellAt(high.y, cells->_size); ++y)
                cells->_sources[keyOf(x, y)].push_back(i);
    }
    return cells;
}

std::shared_ptr<const SourceGrid::Cells> SourceGrid::at(double time) const {
    std::shared_ptr<const Cells> cells = std::atomic_load(&_cells);
    const double now = clampedTime(time, 1e9);
    if (!(std::abs(now - cells->_middle) <= cells->_validFor)) {
        cells = cellsAround(now);
        std::atomic_store(&_cells, cells);
    }
    return cells;
}

Span<const std::uint32_t> SourceGrid::Cells::near(const glm::vec3& place) const {
    const auto found = _sources.find(
        keyOf(cellAt(static_cast<double>(place.x), _size), cellAt(static_cast<double>(place.y), _size)));
    return found != _sources.end() ? Span<const std::uint32_t>(found->second.data(), found->second.size())
                                   : Span<const std::uint32_t>();
}

} // namespace osgTreeWind
