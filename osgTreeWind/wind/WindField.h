// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/wind/LogProfile.h>
#include <osgTreeWind/wind/WindPlace.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <optional>

namespace osgTreeWind {

class WindField;
using WindFieldPtr = std::shared_ptr<const WindField>;

/// Base class of all winds: a velocity for every place and time.
///
/// Positions are metres in the frame of the wind (Wind::frame), velocities m/s in the direction the air moves
/// *toward*, times seconds. Height profiles start at the ground below each place. A field is immutable once
/// shared, and any number of threads may sample it; to change the wind, set another field.
///
///     class Whirl : public WindField {
///     public:
///         glm::vec3 velocity(const WindPlace& place, double) const override {
///             return {-0.1f * place.position.y, 0.1f * place.position.x, 0.0f};
///         }
///     };
///     report(forest->setWind(std::make_shared<Whirl>()));
class OSGTREEWIND_EXPORT WindField {
public:
    virtual ~WindField() = default;

    /// Velocity at a place and time. Finite for finite arguments.
    virtual glm::vec3 velocity(const WindPlace& place, double time) const = 0;

    /// Velocities at `count` places at the same time. Does not allocate.
    virtual void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
        for (std::size_t i = 0; i < count; ++i)
            out[i] = velocity(places[i], time);
    }

    /// The profile that the field has near the ground, valid(); empty if unknown. Gusts over the field use
    /// it.
    virtual std::optional<LogProfile> profile() const { return {}; }

    /// A field whose speed is the standard deviation of the turbulence of this field along its mean, m/s;
    /// null if unknown. Gusts over the field use it.
    virtual WindFieldPtr turbulence() const { return nullptr; }
};

} // namespace osgTreeWind
