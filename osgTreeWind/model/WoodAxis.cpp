// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/WoodAxis.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {

void WoodLine::add(const glm::dvec3& point) {
    arc.push_back(points.empty() ? 0.0 : arc.back() + glm::distance(points.back(), point));
    points.push_back(point);
}

glm::dvec3 WoodLine::at(double along) const {
    const auto after = std::upper_bound(arc.begin(), arc.end(), along);
    if (after == arc.begin())
        return points.front();
    if (after == arc.end())
        return points.back();
    const auto i = static_cast<std::size_t>(after - arc.begin());
    return glm::mix(points[i - 1], points[i], (along - arc[i - 1]) / (arc[i] - arc[i - 1]));
}

} // namespace osgTreeWind
