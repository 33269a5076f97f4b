// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// A place that is far from all others.
struct OutlyingPlace {
    std::string row;
    double distance;   ///< Of its own from the middle of all, metres,
    double others;     ///< and of all but one in a hundred.
    std::size_t count; ///< How many are so far.
};

/// Where the trees of an inventory stand, which tells the one whose place was mistyped.
class SpreadOfPlaces {
public:
    /// @param row says which it is; asked where the place is a kilometre or more beyond all so far.
    void add(const glm::dvec2& place, const std::function<std::string()>& row);
    /// The first place that is at least 10 km from the middle, and 20 times as far from it as the others.
    std::optional<OutlyingPlace> outlier() const;

private:
    std::vector<glm::dvec2> _places;
    glm::dvec2 _low{1e300}, _high{-1e300};
    std::vector<std::pair<std::size_t, std::string>> _edges; ///< Places that were beyond all, and their rows.
};

} // namespace osgTreeWind
