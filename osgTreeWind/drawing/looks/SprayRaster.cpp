// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/SprayRaster.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

/// The sample whose lower or left edge is nearest, clamped to the card.
int nearest(float x) {
    return static_cast<int>(std::lround(glm::clamp(x, 0.0f, 1.0f) * SprayRaster::size));
}

} // namespace

const std::vector<SprayRaster::Span>& SprayRaster::spans(const std::vector<glm::vec2>& polygon) {
    float bottom = 1.0f, top = 0.0f;
    for (const glm::vec2& p : polygon) {
        bottom = glm::min(bottom, p.y);
        top = glm::max(top, p.y);
    }
    const int low = nearest(bottom), high = nearest(top);
    for (std::size_t i = 0; i < polygon.size(); ++i)
        addCrossings(polygon[i], polygon[(i + 1) % polygon.size()], low, high);
    _spans.clear();
    for (int row = low; row < high; ++row) {
        std::vector<float>& crossings = _crossings[static_cast<std::size_t>(row)];
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
            if (const Span span{row, nearest(crossings[i]), nearest(crossings[i + 1])}; span.first < span.end)
                _spans.push_back(span);
        crossings.clear();
    }
    return _spans;
}

/// Adds the intersections of an edge with the middles of the rows [low, high).
void SprayRaster::addCrossings(const glm::vec2& a, const glm::vec2& b, int low, int high) {
    const int first = glm::max(nearest(glm::min(a.y, b.y)) - 1, low),
              end = glm::min(nearest(glm::max(a.y, b.y)) + 1, high);
    for (int row = first; row < end; ++row) {
        const float y = (static_cast<float>(row) + 0.5f) / size;
        if ((a.y <= y) != (b.y <= y))
            _crossings[static_cast<std::size_t>(row)].push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
    }
}

} // namespace osgTreeWind
