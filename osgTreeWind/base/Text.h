// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <algorithm>
#include <istream>
#include <string>
#include <string_view>

namespace osgTreeWind {

/// A position in a text. Lines and columns are 1-based; columns count bytes.
struct TextPosition {
    int line = 1;
    int column = 1;
};

/// The position of the byte at `offset`, at most the end of the text. Lines end in LF, CR LF or CR.
TextPosition positionInText(std::string_view text, std::size_t offset);

/// Checks that bytes are text, and strips a UTF-8 byte-order mark. Empty input is an error, as are control
/// characters other than tab, CR, LF and form feed (binary data).
/// @param file name for diagnostics only.
Result<std::string_view> plainText(std::string_view bytes, const std::string& file);

/// Reads a stream to its end and checks it with plainText(). Exceeding memoryLimit() is an error.
Result<std::string> readText(std::istream& input, const std::string& file);

/// The text, or an empty string for null.
inline std::string orEmpty(const char* text) {
    return text ? text : "";
}

/// The text without leading and trailing spaces, tabs and line ends.
inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// The text with the letters A to Z in lower case.
std::string lower(std::string text);

} // namespace osgTreeWind
