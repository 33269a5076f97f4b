// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <istream>
#include <optional>

namespace osgTreeWind {

/// The width and height, in pixels, that the head of a PNG or JPEG file states. Empty for other formats and
/// for a damaged head.
std::optional<glm::dvec2> pictureSize(std::istream& file);

} // namespace osgTreeWind
