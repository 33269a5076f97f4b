// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/Toml.h>

#include <osgTreeWind/base/MessageText.h>

#include <algorithm>

namespace osgTreeWind {

Result<toml::table> parseToml(const std::string& text, const std::string& source) {
    try {
        return toml::parse(text, source);
    } catch (const toml::parse_error& error) {
        const toml::source_position& at = error.source().begin;
        return Diagnostic{source, static_cast<int>(at.line), static_cast<int>(at.column), "",
                          "not valid TOML: " + printable(std::string(error.description()))};
    }
}

std::size_t lineBegin(const std::string& text, std::size_t line) {
    std::size_t at = 0;
    for (; line > 1 && at < text.size(); --line)
        at = std::min(text.find('\n', at), text.size() - 1) + 1;
    return at;
}

std::size_t offsetOf(const std::string& text, const toml::source_position& position) {
    std::size_t at = lineBegin(text, position.line);
    for (std::size_t column = 1; column < position.column && at < text.size(); ++column)
        do
            ++at;
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80);
    return at;
}

} // namespace osgTreeWind
