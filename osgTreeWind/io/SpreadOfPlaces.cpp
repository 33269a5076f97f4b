// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/SpreadOfPlaces.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {

namespace {

double middleOf(const std::vector<glm::dvec2>& places, int axis) {
    std::vector<double> all;
    all.reserve(places.size());
    for (const glm::dvec2& place : places)
        all.push_back(place[axis]);
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return *middle;
}

} // namespace

void SpreadOfPlaces::add(const glm::dvec2& place, const std::function<std::string()>& row) {
    constexpr double jump = 1000.0; // metres; those between have others near them
    const glm::dvec2 beyond = glm::max(_low - place, place - _high);
    if (_places.empty() || std::max(beyond.x, beyond.y) > jump)
        _edges.emplace_back(_places.size(), row());
    _places.push_back(place);
    _low = glm::min(_low, place);
    _high = glm::max(_high, place);
}

std::optional<OutlyingPlace> SpreadOfPlaces::outlier() const {
    constexpr std::size_t fewest = 4;
    constexpr double timesAsFar = 20.0, least = 10000.0;
    if (_places.size() < fewest || glm::distance(_low, _high) < least)
        return std::nullopt;
    const glm::dvec2 middle(middleOf(_places, 0), middleOf(_places, 1));
    std::vector<double> distances;
    distances.reserve(_places.size());
    for (const glm::dvec2& place : _places)
        distances.push_back(glm::distance(place, middle));
    std::vector<double> sorted = distances;
    const auto usual = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() - 2 - sorted.size() / 100);
    std::nth_element(sorted.begin(), usual, sorted.end());
    const double far = std::max(least, timesAsFar * *usual);
    const auto edge = std::find_if(_edges.begin(), _edges.end(),
                                   [&](const auto& each) { return distances[each.first] > far; });
    if (edge == _edges.end())
        return std::nullopt;
    const auto count =
        std::count_if(distances.begin(), distances.end(), [&](double each) { return each > far; });
    return OutlyingPlace{edge->second, distances[edge->first], *usual, static_cast<std::size_t>(count)};
}

} // namespace osgTreeWind
