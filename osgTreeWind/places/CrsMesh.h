// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsWay.h>

#include <glm/vec2.hpp>

#include <vector>

namespace osgTreeWind {

/// The way of places of a map to another system, known at points of a mesh and interpolated between them:
/// faster than PROJ, and for any number of threads at once.
class CrsMesh {
public:
    /// Points a kilometre apart, linear between them: within 5 cm of PROJ's. A problem where one of them has
    /// no place there.
    /// @param low, high of an area of the map, metres; one wider than 256 km has points farther apart. Beyond
    /// it the way goes on as at its edge. Longitudes are within half a turn of that of its middle.
    static Result<CrsMesh> over(const Crs& from, const Crs& to, const glm::dvec2& low,
                                const glm::dvec2& high);
    /// The same with cubics between them: within a micrometre of PROJ's over the area, where that shifts no
    /// datum by a grid. Places near a point that has none there are NaN. Without north().
    static Result<CrsMesh> smooth(const Crs& from, const Crs& to, const glm::dvec2& low,
                                  const glm::dvec2& high);

    /// Whether a place lies in the area, or at most a square beside it.
    bool covers(const glm::dvec2& place) const;
    /// Whether places there are longitudes and latitudes.
    bool isDegrees() const { return _isDegrees; }
    /// A place there.
    glm::dvec2 there(const glm::dvec2& place) const;
    /// The way north of there, or along the y axis of there, at a place here: a unit vector.
    glm::dvec2 north(const glm::dvec2& place) const;

private:
    struct Point {
        glm::dvec2 there, north;
    };
    static CrsMesh squares(const glm::dvec2& low, const glm::dvec2& high, double fewest);
    std::vector<glm::dvec2> corners() const;
    template <typename Value>
    Value between(const glm::dvec2& at, Value Point::*member) const;
    glm::dvec2 cubic(const glm::dvec2& at) const;
    glm::dvec2 pointAt(const glm::dvec2& place) const;

    glm::dvec2 _low{0.0}, _step{1.0};
    glm::ivec2 _count{2}; ///< Of points, at least 2 each way; 4 of a smooth one.
    std::vector<Point> _points;
    bool _isDegrees = false, _isSmooth = false;
};

} // namespace osgTreeWind
