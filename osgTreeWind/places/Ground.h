// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/vec2.hpp>

#include <memory>
#include <optional>

namespace osgTreeWind {

/// Where a ground is known, in the world's frame, metres.
struct GroundArea {
    glm::dvec2 low{-1e8}; ///< Its least x and y,
    glm::dvec2 high{1e8}; ///< and its greatest.
    double cell = 1.0;    ///< Distance between places whose height was measured.
};

/// The ground that a forest stands on. Immutable once shared: any number of threads may ask one.
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

    /// Metres, at x and y of the world's frame. None over a hole and beyond the edge.
    virtual std::optional<double> height(const glm::dvec2& place) const = 0;
    /// What holds all places that have a height.
    virtual GroundArea area() const = 0;
};

using GroundPtr = std::shared_ptr<const Ground>;

/// What a ground says of a place; none also where that is not a finite number within 1e8 m.
OSGTREEWIND_EXPORT std::optional<double> heightOf(const Ground& ground, const glm::dvec2& place);

/// Height of the foot of a trunk that grows upright on it: the lowest of the trunk's circle. None where there
/// is no ground in its middle. @param radius metres.
OSGTREEWIND_EXPORT std::optional<double> footHeight(const Ground& ground, const glm::dvec2& place,
                                                    double radius);

} // namespace osgTreeWind
