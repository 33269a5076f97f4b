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
    double distance;   ///< From the median of all places, metres.
    double others;     ///< Distance that 99 % of the places do not exceed, metres.
    std::size_t count; ///< Number of outlying places.
};

/// Detects outliers among the places of an inventory's trees, such as mistyped coordinates.
class PlaceSpread {
public:
    /// @param row names the row; called only if the place is over 1 km outside the bounds so far.
    void add(const glm::dvec2& place, const std::function<std::string()>& row);
    /// The first place that is over 10 km, and over 20 times as far as the others, from the median.
    std::optional<OutlyingPlace> outlier() const;

private:
    std::vector<glm::dvec2> _places;
    glm::dvec2 _low{1e300}, _high{-1e300};
    std::vector<std::pair<std::size_t, std::string>> _candidates; ///< Indices and rows of possible outliers.
};

} // namespace osgTreeWind
