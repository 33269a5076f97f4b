// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <istream>
#include <optional>

namespace osgTreeWind {

/// Width and height in pixels that the head of a PNG or JPEG file states. None of another format, or where
/// the head is damaged.
std::optional<glm::dvec2> pictureSize(std::istream& file);

} // namespace osgTreeWind
