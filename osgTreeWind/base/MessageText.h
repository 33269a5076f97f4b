// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Formats texts for messages.
namespace osgTreeWind {

/// The text as UTF-8 with control characters replaced by '?', truncated to about 200 bytes.
std::string printable(const std::string& text);
/// printable() in double quotes.
std::string inQuotes(const std::string& text);
/// "a, b, c".
std::string joined(const std::vector<std::string>& words);
/// "1 to 2.5", rounded to 0.01.
std::string rangeText(double low, double high);
/// "\"a\", \"b\" or \"c\"".
std::string alternatives(const std::vector<std::string>& words);
/// "expected WHAT, found 'TEXT'" on one line. Truncates a long text and calls an empty one "nothing".
std::string expectedFound(std::string_view what, std::string_view text);

} // namespace osgTreeWind
