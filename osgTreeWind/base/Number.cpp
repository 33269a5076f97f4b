// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Number.h>

#include <osgTreeWind/base/Text.h>

#include <charconv>
#include <cmath>

namespace osgTreeWind {

std::optional<double> parseNumber(std::string_view text) {
    text = trimmed(text);
    if (text.size() > 1 && text[0] == '+' && text[1] != '-')
        text.remove_prefix(1);
    double number = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end || !std::isfinite(number))
        return std::nullopt;
    return number;
}

std::string numberText(double number) {
    if (std::abs(number) < 1e15 && number == std::trunc(number))
        return std::to_string(static_cast<long long>(number));
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr};
}

} // namespace osgTreeWind
