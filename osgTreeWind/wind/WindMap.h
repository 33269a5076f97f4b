// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsMesh.h>
#include <osgTreeWind/wind/WindPlace.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <memory>

namespace osgTreeWind {

/// Where the data of a wind lie that is on another map than the scene, or on degrees.
struct WindMap {
    std::shared_ptr<const CrsMesh> mesh; ///< From the scene's map to the data's; not null.
    glm::dvec2 origin{0.0};              ///< (0, 0) of the scene, on its map.
    glm::dvec2 dataOrigin{0.0};          ///< (0, 0) of the data, on theirs.

    /// A place of the scene among the data.
    WindPlace there(const WindPlace& place) const;
    /// A velocity of the data in the scene's axes. @param place in the scene.
    glm::vec3 turned(const WindPlace& place, const glm::vec3& velocity) const;
};

} // namespace osgTreeWind
