// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/DirectionText.h>

#include <osgTreeWind/base/Text.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <map>

namespace osgTreeWind {

std::optional<double> directionUnit(const std::string& name) {
    static const std::map<std::string, double> units = {{"deg", 1.0},
                                                        {"°", 1.0},
                                                        {"degree", 1.0},
                                                        {"degrees", 1.0},
                                                        {"10 deg", 10.0},
                                                        {"10s deg", 10.0},
                                                        {"10's deg", 10.0},
                                                        {"10 degrees", 10.0},
                                                        {"deg/10", 10.0},
                                                        {"10deg", 10.0},
                                                        {"10°", 10.0},
                                                        {"tens of degrees", 10.0},
                                                        {"rad", glm::degrees(1.0)},
                                                        {"radian", glm::degrees(1.0)},
                                                        {"radians", glm::degrees(1.0)}};
    const auto found = units.find(lower(name));
    return found == units.end() ? std::nullopt : std::optional(found->second);
}

std::string directionUnitInName(const std::string& column) {
    std::string name(trimmed(column));
    if (!name.empty() && (name.back() == ')' || name.back() == ']'))
        name.pop_back();
    const std::size_t start = name.find_last_of("([_");
    std::string unit(start == std::string::npos ? "" : trimmed(std::string_view(name).substr(start + 1)));
    return directionUnit(unit) ? unit : std::string();
}

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
