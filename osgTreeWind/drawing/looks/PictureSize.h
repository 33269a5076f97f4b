// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <istream>
#include <optional>

namespace osgTreeWind {

/// Reads width and height in pixels from the header of a PNG or JPEG file; empty if it is neither or damaged.
std::optional<glm::dvec2> pictureSize(std::istream& file);

} // namespace osgTreeWind
