// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/wind/WindPlace.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>

namespace osgTreeWind {

/// The wind: a velocity at every place and time.
///
/// Positions are metres in the axes that it is given in (WindFrame: the forest's own are x east, y north,
/// z up, from its origin); velocities are m/s, the direction the air moves *toward*; times are seconds of
/// simulation time. Fields that know how wind grows with height count it from the ground of each place.
/// Fields are immutable once shared: any number of threads may sample one. Replace a wind by handing over
/// another field.
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

    /// The same wind without turbulence that is made up and not known; null where it makes up none.
    virtual std::shared_ptr<const WindField> withoutGusts() const { return nullptr; }
};

using WindFieldPtr = std::shared_ptr<const WindField>;

} // namespace osgTreeWind
