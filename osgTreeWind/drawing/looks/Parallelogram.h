// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

/// A coordinate of a parallelogram along a row of pixels, in cells: start + step * x.
struct Ramp {
    float start, step;

    /// Clips [first, last) to the pixels whose coordinate is in [0, cells).
    void narrow(int cells, float& first, float& last) const {
        const float perStep = 1.0f / step, zero = -start * perStep,
                    end = zero + static_cast<float>(cells) * perStep;
        first = std::max(first, std::min(zero, end));
        last = std::min(last, std::max(zero, end));
    }
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
    const auto sloped = [](float step) {
        return std::abs(step) < 1e-9f ? 1e-9f : step;
    }; // avoids division by 0
    const auto all = static_cast<float>(cells), width = static_cast<float>(size);
    const float ux = sloped(all * b.y / det), uy = -all * b.x / det;
    const float vx = sloped(-all * a.y / det), vy = all * a.x / det;
    const auto row = [&](float y) { return static_cast<int>(std::clamp(std::ceil(y - 0.5f), 0.0f, width)); };
    const int top = row(corner.y + std::max(a.y, 0.0f) + std::max(b.y, 0.0f));
    for (int y = row(corner.y + std::min(a.y, 0.0f) + std::min(b.y, 0.0f)); y < top; ++y) {
        const float dx = 0.5f - corner.x, dy = static_cast<float>(y) + 0.5f - corner.y;
        const Ramp u{ux * dx + uy * dy, ux}, v{vx * dx + vy * dy, vx};
        float first = 0.0f, end = width;
        u.narrow(cells, first, end);
        v.narrow(cells, first, end);
        if (first < end)
            visit(ParallelogramRow{y, static_cast<int>(std::ceil(first)), static_cast<int>(std::ceil(end)), u,
                                   v, cells});
    }
}

} // namespace osgTreeWind
