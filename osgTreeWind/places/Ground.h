// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/vec2.hpp>

#include <memory>
#include <optional>

namespace osgTreeWind {

/// Extent of a ground in world coordinates, metres.
struct GroundArea {
    glm::dvec2 low{-1e8}; ///< Minimum x and y.
    glm::dvec2 high{1e8}; ///< Maximum x and y.
    double cell = 1.0;    ///< Spacing of the height samples.
};

/// The terrain that a forest stands on. It must not change, because several threads call it at once.
///
///     class Hill : public Ground {
///     public:
///         std::optional<double> height(const glm::dvec2& place) const override {
///             return 20.0 / (1.0 + 1e-4 * (place.x * place.x + place.y * place.y));
///         }
///         GroundArea area() const override { return {}; }
///     };
///     description.ground = std::make_shared<Hill>();
class OSGTREEWIND_EXPORT Ground {
public:
    virtual ~Ground();

    /// Height in metres at world coordinates x and y; empty in a hole and outside the ground.
    virtual std::optional<double> height(const glm::dvec2& place) const = 0;
    /// Bounds of all places that have a height.
    virtual GroundArea area() const = 0;
};

using GroundPtr = std::shared_ptr<const Ground>;

/// Height of the ground at a place; empty also if it is not a finite number within 1e8 m.
OSGTREEWIND_EXPORT std::optional<double> heightOf(const Ground& ground, const glm::dvec2& place);

/// Height of the foot of an upright trunk: the lowest ground within its circle. Empty if there is no ground
/// at its centre. @param radius metres.
OSGTREEWIND_EXPORT std::optional<double> footHeight(const Ground& ground, const glm::dvec2& place,
                                                    double radius);

} // namespace osgTreeWind
