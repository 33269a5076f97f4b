// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsTransform.h>

#include <glm/vec2.hpp>

#include <vector>

namespace osgTreeWind {

/// A CRS transform that is tabulated on a grid of points and interpolated between them. Fast and thread-safe.
class CrsMesh {
public:
    /// Linear interpolation of points up to 1 km apart: within 5 cm of PROJ. Longitudes are within 180
    /// degrees of the centre's.
    /// @param low, high corners of an area of the map, metres, beyond which values are extrapolated. An area
    /// wider than 256 km has a wider spacing and larger errors. @return an error if a point cannot be
    /// transformed.
    static Result<CrsMesh> makeLinear(const Crs& from, const Crs& to, const glm::dvec2& low,
                                      const glm::dvec2& high);
    /// Cubic interpolation: within 1 µm of PROJ in the area, unless PROJ uses a datum shift grid. Places near
    /// a point that cannot be transformed are NaN. Does not support north().
    static Result<CrsMesh> makeCubic(const Crs& from, const Crs& to, const glm::dvec2& low,
                                     const glm::dvec2& high);

    /// Whether a place is in the area, or at most one grid cell outside it.
    bool covers(const glm::dvec2& place) const;
    /// Whether the target system is longitude and latitude.
    bool isDegrees() const { return _isDegrees; }
    /// The place in the target system.
    glm::dvec2 transformed(const glm::dvec2& place) const;
    /// Direction of the target system's north, or y axis, at a place of the map: a unit vector.
    glm::dvec2 north(const glm::dvec2& place) const;

private:
    struct Point {
        glm::dvec2 target, north;
    };
    /// A grid without values.
    static CrsMesh makeGrid(const glm::dvec2& low, const glm::dvec2& high, double minCells);
    std::vector<glm::dvec2> gridPoints() const;
    template <typename Value>
    Value interpolateLinear(const glm::dvec2& at, Value Point::*member) const;
    glm::dvec2 interpolateCubic(const glm::dvec2& at) const;
    glm::dvec2 gridCoordinates(const glm::dvec2& place) const;

    glm::dvec2 _low{0.0}, _step{1.0};
    glm::ivec2 _count{2}; ///< Points along each axis; at least 4 for cubic interpolation.
    std::vector<Point> _points;
    bool _isDegrees = false, _isCubic = false;
};

} // namespace osgTreeWind
