// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace osgTreeWind {

/// Parses one finite decimal number, ignoring blanks around it. Empty for anything else (no text, trailing
/// text, "nan", "inf", out of range). Independent of the locale.
std::optional<double> parseNumber(std::string_view text);

/// The shortest text that parses to exactly `number`, in any locale. Integers below 1e15 have no exponent.
std::string numberText(double number);

} // namespace osgTreeWind
