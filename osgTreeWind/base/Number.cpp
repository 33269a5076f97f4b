// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Number.h>

#include <osgTreeWind/base/Text.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr std::size_t longestQuote = 40;

} // namespace

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

std::string expectedFound(std::string_view what, std::string_view text) {
    text = trimmed(text);
    std::string message = "expected " + std::string(what) + ", found ";
    if (text.empty())
        return message + "nothing";
    std::string quote(text.substr(0, longestQuote));
    std::replace_if(
        quote.begin(), quote.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return message + "'" + quote + (text.size() > longestQuote ? "...'" : "'");
}

} // namespace osgTreeWind
