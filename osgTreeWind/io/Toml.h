// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

// TOML_HEADER_ONLY and TOML_SHARED_LIB come from the package of toml++. The compiled library of Debian
// reports text that violates assertions of the header-only one ("[=]", "a = é").
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include <cstddef>
#include <string>

namespace osgTreeWind {

/// Parses a document. The problem has a line and a column, and `source` as its file.
/// @param source of the nodes; empty if they need none.
Result<toml::table> parseToml(const std::string& text, const std::string& source = {});

/// The byte offset at which a line begins; at most the size of the text. @param line from 1.
std::size_t lineBegin(const std::string& text, std::size_t line);
/// The byte offset of a position, whose columns count UTF-8 characters.
std::size_t offsetOf(const std::string& text, const toml::source_position& position);

} // namespace osgTreeWind
