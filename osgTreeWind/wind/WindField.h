// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <functional>
#include <memory>

namespace osgTreeWind {

/// Whose axes a wind is given in: its places, its velocities and what is up (docs/coordinates.md).
enum class WindFrame {
    Forest,    ///< The forest's own, metres from its origin: it stays with the forest wherever that is put.
    Scene,     ///< Those of the scene's root, z up; or of the world less the forest's origin, where the
               ///< forest stands nearer to its origin than to the scene's zero.
    Geocentric ///< Those of the scene's root, which is a globe: up is the forest's own z.
};

/// Where wind is asked for: a position, and how far above the ground that is. Metres.
struct WindPlace {
    glm::vec3 position{0.0f}; ///< Metres.
    float height = 0.0f;      ///< Above the ground below it.
    bool inCrown = false;     ///< Between the leaves of a tree: a stand shelters them from the air around it.

    WindPlace() = default;
    /// Over ground at z = `ground`.
    WindPlace(const glm::vec3& at, float ground = 0.0f) : position(at), height(at.z - ground) {}
    /// Over ground at z = 0.
    WindPlace(float x, float y, float z) : position(x, y, z), height(z) {}
};

class WindField;
using WindFieldPtr = std::shared_ptr<const WindField>;
/// Makes another wind of one; null is calm.
using WindChange = std::function<WindFieldPtr(const WindFieldPtr&)>;

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
    virtual WindFieldPtr withoutGusts() const { return nullptr; }

    /// The same wind with a change of what blows beside its sources (WindWithSources); null where it has
    /// none.
    virtual WindFieldPtr changedBesideSources(const WindChange&) const { return nullptr; }
};

} // namespace osgTreeWind
