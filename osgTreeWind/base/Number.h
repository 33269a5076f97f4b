// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace osgTreeWind {

/// The text as one finite decimal number, blanks around it ignored; empty for anything else
/// (no text, trailing text, "nan", "inf", out of range). Independent of the locale.
std::optional<double> parseNumber(std::string_view text);

/// The shortest text that reads back as `number`, whole numbers below 1e15 without an exponent.
/// Independent of the locale.
std::string numberText(double number);

/// "expected WHAT, found 'TEXT'", on one line: a long text is cut, an empty one called nothing.
std::string expectedFound(std::string_view what, std::string_view text);

} // namespace osgTreeWind
