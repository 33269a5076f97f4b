// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace osgTreeWind {

/// Whether bytes are UTF-8 as RFC 3629 has it: no surrogates, nothing longer than needed.
bool isUtf8(std::string_view bytes);

/// A text as UTF-8.
struct DecodedText {
    std::string text;
    std::string assumed; ///< The encoding that the bytes were taken to have; empty where they say it.
};

/// Bytes as UTF-8: they are UTF-8 already, or UTF-16 behind a byte-order mark, or else Windows-1252, of which
/// ISO 8859-1 is a part.
DecodedText decodeText(std::string bytes);

/// Without blanks around it, with one blank for blanks of any kind within, in lower case in any script.
std::string foldedName(std::string_view text);

/// A name as common names are compared: in lower case, without accents, blanks, hyphens and apostrophes, and
/// ae, oe and ue as a, o and u. "Roßkastanie" and "rosskastanie" are one, as are "Bäume", "Baume" and
/// "Baeume".
std::string comparableName(std::string_view text);

} // namespace osgTreeWind
