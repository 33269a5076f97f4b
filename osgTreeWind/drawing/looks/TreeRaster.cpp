// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/TreeRaster.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

/// u or v along a row, in cells: start + step * x.
struct Ramp {
    float start, step, perStep;

    /// Narrows [first, last) to where it lies within the piece.
    void narrow(float& first, float& last) const {
        const float zero = -start * perStep, end = zero + TreeRaster::cells * perStep;
        first = std::max(first, std::min(zero, end));
        last = std::min(last, std::max(zero, end));
    }
    int cell(float x) const { return static_cast<int>(start + step * x) & (TreeRaster::cells - 1); }
};

/// A slope that can be divided by.
float sloped(float step) {
    return std::abs(step) < 1e-9f ? 1e-9f : step;
}

} // namespace

void TreeRaster::clear() {
    std::fill(_samples.begin(), _samples.end(), Sample{-1e30f, nothing, 0});
}

void TreeRaster::draw(const Piece& piece, const Stencil& stencil, std::uint32_t item) {
    const glm::vec3 &a = piece.across, &b = piece.along;
    const float det = a.x * b.y - a.y * b.x;
    if (!(std::abs(det) > 1e-6f))
        return;
    const float ux = sloped(cells * b.y / det), uy = -cells * b.x / det;
    const float vx = sloped(-cells * a.y / det), vy = cells * a.x / det;
    const float perU = 1.0f / ux, perV = 1.0f / vx;
    const glm::vec2 perCell = glm::vec2(a.z, b.z) / static_cast<float>(cells);
    const float slope = ux * perCell.x + vx * perCell.y;
    const float size = static_cast<float>(_size);
    const float low = piece.corner.y + std::min(a.y, 0.0f) + std::min(b.y, 0.0f);
    const float high = piece.corner.y + std::max(a.y, 0.0f) + std::max(b.y, 0.0f);
    const int end = static_cast<int>(std::clamp(std::ceil(high - 0.5f), 0.0f, size));
    for (int y = static_cast<int>(std::clamp(std::ceil(low - 0.5f), 0.0f, size)); y < end; ++y) {
        const float dx = 0.5f - piece.corner.x, dy = static_cast<float>(y) + 0.5f - piece.corner.y;
        const Ramp u{ux * dx + uy * dy, ux, perU}, v{vx * dx + vy * dy, vx, perV};
        float first = 0.0f, last = size;
        u.narrow(first, last);
        v.narrow(first, last);
        Sample* row = &_samples[static_cast<std::size_t>(y * _size)];
        const float depth = piece.corner.z + u.start * perCell.x + v.start * perCell.y;
        const int stop = static_cast<int>(std::ceil(last));
        for (int x = static_cast<int>(std::ceil(first)); x < stop; ++x) {
            const float at = static_cast<float>(x);
            if (depth + slope * at <= row[x].depth)
                continue;
            const int cell = u.cell(at) + cells * v.cell(at);
            if (stencil[static_cast<std::size_t>(cell)])
                row[x] = {depth + slope * at, item, cell};
        }
    }
}

} // namespace osgTreeWind
