// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

/// A coordinate of a parallelogram along a row of pixels, in cells: start + step * x.
struct Ramp {
    float start, step;

    /// @param cells a power of two.
    int cell(float x, int cells) const { return static_cast<int>(start + step * x) & (cells - 1); }
};

/// The pixels [first, end) of row y whose centres are in a parallelogram.
struct ParallelogramRow {
    int y, first, end;
    Ramp u, v; ///< Along the two edges.
    int cells;

    /// The cell at a pixel: u + cells * v.
    int cell(int x) const {
        const auto at = static_cast<float>(x);
        return u.cell(at, cells) + cells * v.cell(at, cells);
    }
};

/// Rasterizes a parallelogram: calls visit(ParallelogramRow) for each row of a square picture of `size`
/// pixels that corner + u * a + v * b intersects, u and v in [0, 1). Skips degenerate and infinite
/// parallelograms.
/// @param cells number of cells along each edge, a power of two.
template <typename Visit>
void visitParallelogram(const glm::vec2& corner, const glm::vec2& a, const glm::vec2& b, int cells, int size,
                        const Visit& visit) {
    const float det = a.x * b.y - a.y * b.x;
    if (!(std::abs(det) > 1e-6f) || !std::isfinite(det + corner.x + corner.y))
        return;
    const auto width = static_cast<float>(size);
    const auto up = [](float place) { // std::ceil() of a number that is not negative, which calls no function
        const int whole = static_cast<int>(place);
        return static_cast<float>(whole) < place ? whole + 1 : whole;
    };
    const auto row = [&](float y) { return up(std::clamp(y - 0.5f, 0.0f, width)); };
    const int low = row(corner.y + std::min(a.y, 0.0f) + std::min(b.y, 0.0f)),
              top = row(corner.y + std::max(a.y, 0.0f) + std::max(b.y, 0.0f));
    if (low >= top)
        return;
    const auto sloped = [](float step) {
        return std::abs(step) < 1e-9f ? 1e-9f : step;
    }; // avoids division by 0
    const auto all = static_cast<float>(cells);
    const float ux = sloped(all * b.y / det), uy = -all * b.x / det;
    const float vx = sloped(-all * a.y / det), vy = all * a.x / det;
    const float perU = 1.0f / ux, perV = 1.0f / vx, widthOfU = all * perU, widthOfV = all * perV; // pixels
    for (int y = low; y < top; ++y) {
        const float dx = 0.5f - corner.x, dy = static_cast<float>(y) + 0.5f - corner.y;
        const Ramp u{ux * dx + uy * dy, ux}, v{vx * dx + vy * dy, vx};
        const float zeroOfU = -u.start * perU, endOfU = zeroOfU + widthOfU;
        const float zeroOfV = -v.start * perV, endOfV = zeroOfV + widthOfV;
        const float first = std::max(std::max(0.0f, std::min(zeroOfU, endOfU)), std::min(zeroOfV, endOfV));
        const float end = std::min(std::min(width, std::max(zeroOfU, endOfU)), std::max(zeroOfV, endOfV));
        if (first < end)
            visit(ParallelogramRow{y, up(first), up(end), u, v, cells});
    }
}

} // namespace osgTreeWind
