// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafTexels.h>
#include <osgTreeWind/drawing/looks/SprayPieces.h>
#include <osgTreeWind/drawing/looks/SprayRaster.h>

#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// Where sprays are painted: what comes later covers what came before.
class SprayCanvas {
public:
    SprayCanvas();

    /// As wide when bare; in leaf less so.
    void addTwigs(const std::vector<TwigPiece>& twigs);
    void addLeaf(const LeafOutline& outline, const LeafBlade& blade);

    LeafTexels texels() const;

private:
    static constexpr std::uint8_t leaf = 1, bareTwig = 2, leafyTwig = 4;

    SprayRaster _raster;
    std::vector<std::uint8_t> _brightness, _hue, _parts;
};

} // namespace osgTreeWind
