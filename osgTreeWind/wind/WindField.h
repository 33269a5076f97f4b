// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/wind/WindPlace.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <variant>

namespace osgTreeWind {

class ForestWind;
class GridWind;
class GustWind;
class TimeSeriesWind;
class UniformWind;
class WindField;
using WindFieldPtr = std::shared_ptr<const WindField>;

/// A field by its kind, if a file can say that kind; otherwise as a WindField.
using KindOfWind = std::variant<const WindField*, const UniformWind*, const GustWind*, const GridWind*,
                                const ForestWind*, const TimeSeriesWind*>;

/// A velocity at every place and time: what a Wind is made of.
///
/// Positions are metres in the axes that the wind is given in (Wind::frame); velocities are m/s, the
/// direction the air moves *toward*; times are seconds. Fields that know how wind grows with height count it
/// from the ground of each place. Fields are immutable once shared: any number of threads may sample one.
/// Replace a wind by handing over another field.
///
///     class Whirl : public WindField {
///     public:
///         glm::vec3 velocity(const WindPlace& place, double) const override {
///             return {-0.1f * place.position.y, 0.1f * place.position.x, 0.0f};
///         }
///     };
///     forest->setWind(std::make_shared<Whirl>());
class OSGTREEWIND_EXPORT WindField {
public:
    virtual ~WindField() = default;

    /// Velocity at one place and time. Finite for finite arguments.
    virtual glm::vec3 velocity(const WindPlace& place, double time) const = 0;

    /// Velocities at `count` places at one time. Does not allocate.
    virtual void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
        for (std::size_t i = 0; i < count; ++i)
            out[i] = velocity(places[i], time);
    }

    /// The same field without turbulence that is made up and not known; null where it makes up none.
    virtual WindFieldPtr withoutGusts() const { return nullptr; }

    /// Which of the kinds it is that a file can say.
    virtual KindOfWind kind() const { return this; }
};

} // namespace osgTreeWind
