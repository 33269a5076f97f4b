// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <algorithm>
#include <istream>
#include <string>
#include <string_view>

namespace osgTreeWind {

/// A place in a text, both 1-based; columns count bytes.
struct TextPlace {
    int line = 1;
    int column = 1;
};

/// Where the byte at `offset` stands; offsets past the end give the end. Lines end in LF, CR LF or CR.
TextPlace placeInText(std::string_view text, std::size_t offset);

/// Bytes as a text, without a UTF-8 byte-order mark. No bytes at all, and control characters other than tab,
/// CR, LF and form feed (binary data) are errors.
/// @param file name for diagnostics only.
Result<std::string_view> plainText(std::string_view bytes, const std::string& file);

/// All of a text input, and what plainText() says of it; an unreadable stream (a folder, say) is an error.
Result<std::string> readText(std::istream& input, const std::string& file);

/// Null becomes an empty text.
inline std::string orEmpty(const char* text) {
    return text ? text : "";
}

/// Without spaces, tabs and line ends around it.
inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// With letters A to Z in lower case.
std::string lower(std::string text);

} // namespace osgTreeWind
