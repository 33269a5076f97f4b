// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

std::string printable(std::string text) {
    constexpr std::size_t maxLength = 200;
    if (text.size() > maxLength) {
        std::size_t end = maxLength;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80)
            --end; // do not split a UTF-8 character
        text = text.substr(0, end) + "...";
    }
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return text;
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
    std::string quote(text.substr(0, longestQuote));
    std::replace_if(
        quote.begin(), quote.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return message + "'" + quote + (text.size() > longestQuote ? "...'" : "'");
}

} // namespace osgTreeWind
