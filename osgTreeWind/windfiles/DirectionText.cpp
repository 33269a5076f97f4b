// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/DirectionText.h>

#include <osgTreeWind/base/Text.h>

#include <algorithm>

namespace osgTreeWind {

std::optional<double> compassDirection(const std::string& text) {
    static const char* const points[] = {"n", "nne", "ne", "ene", "e", "ese", "se", "sse",
                                         "s", "ssw", "sw", "wsw", "w", "wnw", "nw", "nnw"};
    std::string point = lower(text);
    for (const char* word : {"north", "east", "south", "west"})
        for (std::size_t at; (at = point.find(word)) != std::string::npos;)
            point.erase(at + 1, std::string_view(word).size() - 1);
    point.erase(std::remove_if(point.begin(), point.end(), [](char c) { return c == ' ' || c == '-'; }),
                point.end());
    const auto found = std::find(std::begin(points), std::end(points), point);
    if (found == std::end(points))
        return std::nullopt;
    return 22.5 * static_cast<double>(found - std::begin(points));
}

bool isVariableDirection(const std::string& text) {
    const std::string word = lower(std::string(trimmed(text)));
    return word == "vrb" || word == "var" || word == "variable";
}

} // namespace osgTreeWind
