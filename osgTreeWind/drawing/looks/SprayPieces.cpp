// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/SprayPieces.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace osgTreeWind {

glm::vec3 LeafBlade::point(const glm::vec2& outline) const {
    const glm::vec2 along{math::sin(lean), math::cos(lean)}, side{along.y, -along.x};
    const glm::vec2 way{math::sin(toward), math::cos(toward)};
    const glm::vec2 flat = length * (outline.x * side + outline.y * along);
    const float reach = glm::dot(flat, way);
    return {foot + flat + (math::cos(tilt) - 1.0f) * reach * way, math::sin(tilt) * reach};
}

std::vector<glm::vec2> LeafBlade::polygon(const LeafOutline& outline) const {
    std::vector<glm::vec2> polygon;
    for (const glm::vec2& p : outline)
        polygon.emplace_back(point(p));
    for (std::size_t i = outline.size(); i-- > 0;)
        polygon.emplace_back(point({-outline[i].x, outline[i].y}));
    return polygon;
}

std::vector<glm::vec2> TwigPiece::polygon() const {
    const glm::vec2 along = glm::normalize(end - foot), side{along.y, -along.x};
    const glm::vec2 low = 0.5f * footWidth * side, high = 0.5f * endWidth * side;
    return {foot - low, foot + low, end + high, end - high};
}

} // namespace osgTreeWind
