// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsWay.h>

#include <glm/vec2.hpp>

#include <vector>

namespace osgTreeWind {

/// The way of places of a map to another system, known at points a kilometre apart and linear between them:
/// within 5 cm of PROJ's, faster than it, and for any number of threads at once.
class CrsMesh {
public:
    /// @param low, high of an area of the map, metres; one wider than 256 km has points farther apart. Beyond
    /// it the way goes on as at its edge. Longitudes are within half a turn of that of its middle.
    static Result<CrsMesh> over(const Crs& from, const Crs& to, const glm::dvec2& low,
                                const glm::dvec2& high);

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
    template <typename Value>
    Value between(const glm::dvec2& at, Value Point::*member) const;
    glm::dvec2 pointAt(const glm::dvec2& place) const;

    glm::dvec2 _low{0.0}, _step{1.0};
    glm::ivec2 _count{2}; ///< Of points, at least 2 each way.
    std::vector<Point> _points;
    bool _isDegrees = false;
};

} // namespace osgTreeWind
