// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsMesh.h>
#include <osgTreeWind/wind/WindPlace.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <memory>

namespace osgTreeWind {

/// Transform between the scene and wind data in another CRS, projected or in degrees.
struct DataTransform {
    std::shared_ptr<const CrsMesh> mesh; ///< From the scene's CRS to that of the data; not null.
    glm::dvec2 origin{0.0};              ///< Scene (0, 0) in the scene's CRS.
    glm::dvec2 dataOrigin{0.0};          ///< Data (0, 0) in the data's CRS.

    /// Transforms a place from the scene to the data.
    WindPlace toData(const WindPlace& place) const;
    /// Turns a velocity from the data's axes to the scene's. @param place in the scene.
    glm::vec3 toScene(const WindPlace& place, const glm::vec3& velocity) const;
};

} // namespace osgTreeWind
