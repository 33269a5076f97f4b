// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace osgTreeWind {

/// What several numbers in one text mean.
enum class SizeKind {
    Height, ///< A class: "10/15" is one, too.
    Width,  ///< A class, or the extents of a crown: "8 x 6" has the mean of 7.
    Trunk   ///< A class, or stems: "12+14+9" and "3x10" have the root of the sum of squares.
};

/// A size in words.
struct SizeText {
    double value = 0.0;
    bool isInMetres = false; ///< Whether the text names a unit. Otherwise the value is in that of the column.
    bool isEstimate = false; ///< Whether the text is a class, a bound, or "about" the value.
};

/// Reads a size in words: "18.5", "18,5 m", "45 cm", "60'", "45'6\"", "~20", "ca. 20", a class such as "9-12"
/// or "B (9-12 m)" (its middle), ">18", "18+" or "under 6" (its bound), and those of SizeKind. Words are
/// English, German, French or Dutch. @param commaSeparates whether "20,15" are two stems; "20, 15" and
/// "12,14,9" always are.
/// @return empty for anything else, such as two stems in a height.
std::optional<SizeText> parseSize(std::string_view text, SizeKind kind, bool commaSeparates = false);

/// Whether the commas in a text separate numbers, as in "12,14,9" and "12.5,14", or are decimal, as in "0,45"
/// and "12,05". Empty if the text does not tell: then other texts of its column may.
std::optional<bool> commaSeparatesNumbers(std::string_view text);

} // namespace osgTreeWind
