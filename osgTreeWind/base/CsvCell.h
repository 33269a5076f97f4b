// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// A text as a cell of CSV, in quotes where it needs them.
inline std::string csvCell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

/// Texts as a line of CSV, with its end.
template <typename Texts>
std::string csvLine(const Texts& texts) {
    std::string line;
    for (const auto& text : texts)
        line += (&text == &*texts.begin() ? "" : ",") + csvCell(text);
    return line + '\n';
}

} // namespace osgTreeWind
