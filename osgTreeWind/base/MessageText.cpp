// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/base/Unicode.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

/// UTF-8 of about `maxLength` bytes and "...".
std::string shortened(std::string_view text, std::size_t maxLength) {
    if (text.size() <= maxLength)
        return asUtf8(std::string(text));
    std::size_t end = maxLength;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80)
        --end; // do not split a UTF-8 character
    return asUtf8(std::string(text.substr(0, end))) + "...";
}

} // namespace

std::string printable(const std::string& text) {
    constexpr std::size_t maxLength = 200;
    std::string shown = shortened(text, maxLength);
    std::replace_if(
        shown.begin(), shown.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return shown;
}

std::string inQuotes(const std::string& text) {
    return '"' + printable(text) + '"';
}

std::string joined(const std::vector<std::string>& words) {
    std::string result;
    for (const std::string& word : words)
        result += (result.empty() ? "" : ", ") + printable(word);
    return result;
}

std::string rangeText(double low, double high) {
    const auto rounded = [](double number) { return numberText(std::round(100.0 * number) / 100.0); };
    return rounded(low) + " to " + rounded(high);
}

std::string alternatives(const std::vector<std::string>& words) {
    std::string result;
    for (std::size_t i = 0; i < words.size(); ++i)
        result += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + inQuotes(words[i]);
    return result;
}

std::string expectedFound(std::string_view what, std::string_view text) {
    constexpr std::size_t longestQuote = 40;
    text = trimmed(text);
    std::string message = "expected " + std::string(what) + ", found ";
    if (text.empty())
        return message + "nothing";
    std::string quote = shortened(text, longestQuote);
    std::replace_if(
        quote.begin(), quote.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return message + "'" + quote + "'";
}

} // namespace osgTreeWind
