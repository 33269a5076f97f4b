// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// The text as a CSV cell, quoted if needed. Readers trim cells, so leading and trailing blanks need it.
inline std::string csvCell(const std::string& text) {
    constexpr const char *special = ",\"\r\n", *blanks = " \t";
    const bool needsQuotes = text.find_first_of(special) != std::string::npos ||
                             text.find_first_of(blanks) == 0 || text.find_last_of(blanks) + 1 == text.size();
    if (!needsQuotes || text.empty())
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

/// The texts as one CSV line, including the line end.
template <typename Texts>
std::string csvLine(const Texts& texts) {
    std::string line;
    for (const auto& text : texts)
        line += (&text == &*texts.begin() ? "" : ",") + csvCell(text);
    return line + '\n';
}

} // namespace osgTreeWind
