// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TomlPosition.h>

#include <algorithm>

namespace osgTreeWind {

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
