// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafTexels.h>
#include <osgTreeWind/drawing/looks/SprayPieces.h>
#include <osgTreeWind/drawing/looks/SprayRaster.h>

#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// A canvas for painting sprays. Later pieces cover earlier ones.
class SprayCanvas {
public:
    SprayCanvas();

    /// Paints twigs at full width on the bare spray, and thinner on the spray in leaf.
    void addTwigs(const std::vector<TwigPiece>& twigs);
    void addLeaf(const LeafOutline& outline, const LeafBlade& blade);

    LeafTexels texels() const;

private:
    static constexpr std::uint8_t leaf = 1, bareTwig = 2, leafyTwig = 4;

    SprayRaster _raster;
    std::vector<std::uint8_t> _brightness, _hue, _parts;
};

} // namespace osgTreeWind
