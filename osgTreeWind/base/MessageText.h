// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// Words as they stand in messages.
namespace osgTreeWind {

/// With control characters replaced by '?', cut to 200 bytes.
std::string printable(std::string text);
/// printable() between double quotes.
std::string inQuotes(const std::string& text);
/// "a, b, c".
std::string joined(const std::vector<std::string>& words);
/// "\"a\", \"b\" or \"c\"".
std::string alternatives(const std::vector<std::string>& words);

} // namespace osgTreeWind
