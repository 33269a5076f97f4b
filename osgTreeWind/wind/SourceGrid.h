// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Span.h>
#include <osgTreeWind/wind/SourceFlow.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace osgTreeWind {

/// The sources of a wind in a grid, so that a place asks only those near it. Safe to use from any number of
/// threads.
class SourceGrid {
public:
    explicit SourceGrid(const std::vector<WindSource>& sources);

    bool isEmpty() const { return _flows.empty(); }
    const std::vector<SourceFlow>& flows() const { return _flows; }

    /// Which sources reach into the cells of a grid, for a span of time.
    class Cells {
    public:
        /// By ascending index; some of them may not reach the place itself. As long as the cells exist.
        Span<const std::uint32_t> near(const glm::vec3& place) const;

    private:
        friend class SourceGrid;
        double _middle = 0.0;   ///< Of that span, seconds.
        double _validFor = 0.0; ///< Before and after the middle, seconds.
        double _size = 1.0;     ///< Of a cell, metres.
        std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> _sources;
    };
    /// At a time. Where sources move, cells are made anew, which allocates, about each time that one of them
    /// has moved as far as it reaches. Not for an empty grid.
    std::shared_ptr<const Cells> at(double time) const;

private:
    std::shared_ptr<const Cells> cellsAround(double time) const;

    std::vector<SourceFlow> _flows;
    double _validFor; ///< Cells hold so long before and after the time they were made for, seconds.
    mutable std::shared_ptr<const Cells> _cells; ///< The last ones; atomic.
};

} // namespace osgTreeWind
