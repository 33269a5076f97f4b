// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/PlaceSpread.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {

namespace {

double medianOf(const std::vector<glm::dvec2>& places, int axis) {
    std::vector<double> all;
    all.reserve(places.size());
    for (const glm::dvec2& place : places)
        all.push_back(place[axis]);
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return *middle;
}

} // namespace

void PlaceSpread::add(const glm::dvec2& place, const std::function<std::string()>& row) {
    constexpr double minGap = 1000.0; // metres
    const glm::dvec2 outside = glm::max(_low - place, place - _high);
    if (_places.empty() || std::max(outside.x, outside.y) > minGap)
        _candidates.emplace_back(_places.size(), row());
    _places.push_back(place);
    _low = glm::min(_low, place);
    _high = glm::max(_high, place);
}

std::optional<OutlyingPlace> PlaceSpread::outlier() const {
    constexpr std::size_t minPlaces = 4;
    constexpr double minRatio = 20.0, minDistance = 10000.0;
    if (_places.size() < minPlaces || glm::distance(_low, _high) < minDistance)
        return std::nullopt;
    const glm::dvec2 median(medianOf(_places, 0), medianOf(_places, 1));
    std::vector<double> distances;
    distances.reserve(_places.size());
    for (const glm::dvec2& place : _places)
        distances.push_back(glm::distance(place, median));
    std::vector<double> sorted = distances;
    const auto others = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() - 2 - sorted.size() / 100);
    std::nth_element(sorted.begin(), others, sorted.end());
    const double limit = std::max(minDistance, minRatio * *others);
    const auto first = std::find_if(_candidates.begin(), _candidates.end(), [&](const auto& candidate) {
        return distances[candidate.first] > limit;
    });
    if (first == _candidates.end())
        return std::nullopt;
    const auto count =
        std::count_if(distances.begin(), distances.end(), [&](double distance) { return distance > limit; });
    return OutlyingPlace{first->second, distances[first->first], *others, static_cast<std::size_t>(count)};
}

} // namespace osgTreeWind
