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

/// Spatial index of the sources of a wind: finds the sources that may reach a place. Thread-safe.
class SourceGrid {
public:
    explicit SourceGrid(const std::vector<WindSource>& sources);

    bool isEmpty() const { return _flows.empty(); }
    const std::vector<SourceFlow>& flows() const { return _flows; }

    /// The sources that reach each cell of a horizontal grid, for a span of time.
    class Cells {
    public:
        /// Indices of the sources that may reach a place, ascending. Valid while these Cells exist.
        Span<const std::uint32_t> near(const glm::vec3& place) const;

    private:
        friend class SourceGrid;
        double _middle = 0.0;   ///< Middle of the time span, seconds.
        double _validFor = 0.0; ///< Half of the time span, seconds.
        double _size = 1.0;     ///< Cell size, metres.
        std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> _sources;
    };
    /// The cells at a time. If sources move, they are rebuilt (which allocates) about each time that one of
    /// them has moved by its reach. Not for an empty grid.
    std::shared_ptr<const Cells> at(double time) const;

private:
    std::shared_ptr<const Cells> cellsAround(double time) const;

    std::vector<SourceFlow> _flows;
    double _validFor; ///< Cells are valid this long before and after the time they were built for, seconds.
    mutable std::shared_ptr<const Cells> _cells; ///< The latest cells; access only atomically.
};

} // namespace osgTreeWind
