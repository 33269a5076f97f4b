// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/Toml.h>

#include <string>

namespace osgTreeWind {

/// The byte offset at which a line begins; at most the size of the text. @param line from 1.
std::size_t lineBegin(const std::string& text, std::size_t line);
/// The byte offset of a position, whose columns count UTF-8 characters.
std::size_t offsetOf(const std::string& text, const toml::source_position& position);

} // namespace osgTreeWind
