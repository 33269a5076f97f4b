// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/TreeRaster.h>

#include <osgTreeWind/drawing/looks/Parallelogram.h>

#include <algorithm>

namespace osgTreeWind {

void TreeRaster::clear() {
    std::fill(_samples.begin(), _samples.end(), Sample{-1e30f, nothing, 0});
}

void TreeRaster::draw(const Piece& piece, const Stencil& stencil, std::uint32_t item) {
    const glm::vec2 perCell = glm::vec2(piece.across.z, piece.along.z) / static_cast<float>(cells);
    visitParallelogram(piece.corner, piece.across, piece.along, cells, _size, [&](const auto& row) {
        Sample* samples = &_samples[static_cast<std::size_t>(row.y * _size)];
        const float slope = row.u.step * perCell.x + row.v.step * perCell.y;
        const float depth = piece.corner.z + row.u.start * perCell.x + row.v.start * perCell.y;
        for (int x = row.first; x < row.end; ++x) {
            const float here = depth + slope * static_cast<float>(x);
            if (here <= samples[x].depth)
                continue;
            const int cell = row.cell(x);
            if (stencil[static_cast<std::size_t>(cell)])
                samples[x] = {here, item, cell};
        }
    });
}

} // namespace osgTreeWind
