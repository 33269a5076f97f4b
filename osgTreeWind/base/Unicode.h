// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace osgTreeWind {

/// Whether bytes are valid UTF-8 (RFC 3629): no surrogates, no overlong forms.
bool isUtf8(std::string_view bytes);

/// The text if it is UTF-8, otherwise converted from Windows-1252.
std::string asUtf8(std::string text);

/// A text converted to UTF-8.
struct DecodedText {
    std::string text;
    std::string assumed; ///< Encoding that was assumed; empty if it was certain.
};

/// Converts bytes to UTF-8. They are UTF-8, UTF-16 with a byte-order mark, or else Windows-1252.
DecodedText decodeText(std::string bytes);

/// The text trimmed, with each run of blanks as one space, and in lower case for all scripts.
std::string foldedName(std::string_view text);

/// A key for comparing common names: lower case, without accents, blanks, hyphens and apostrophes, and with
/// ae, oe and ue as a, o and u. "Roßkastanie" equals "rosskastanie", and "Bäume" equals "Baume" and "Baeume".
std::string comparableName(std::string_view text);

} // namespace osgTreeWind
