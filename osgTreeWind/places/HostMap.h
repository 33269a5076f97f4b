// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <string>

namespace osgTreeWind {

/// The transform from a forest's node, metres from its `origin` in its `crs`, to the CRS of the host's scene.
/// It rotates and scales horizontally to match the host's projection at the forest's origin, and keeps
/// heights. The error grows away from the origin: millimetres per kilometre between UTM zones.
/// @return an error if a CRS is missing or not in metres, or the origin is outside the host's projection.
OSGTREEWIND_EXPORT Result<glm::dmat4> hostMapTransform(const std::string& crs, const glm::dvec3& origin,
                                                       const std::string& hostCrs);

} // namespace osgTreeWind
