// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// A text as a cell of CSV, in quotes where it needs them: readers drop blanks about a cell.
inline std::string csvCell(const std::string& text) {
    constexpr const char *marks = ",\"\r\n", *blanks = " \t";
    const bool isBare = text.find_first_of(marks) == std::string::npos && text.find_first_of(blanks) != 0 &&
                        text.find_last_of(blanks) + 1 != text.size();
    if (isBare || text.empty())
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
