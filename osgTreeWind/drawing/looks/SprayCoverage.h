// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/SprayPieces.h>
#include <osgTreeWind/drawing/looks/SprayRaster.h>

#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// Measures the coverage of the card of a spray while the spray grows.
class SprayCoverage {
public:
    /// Scales the widths of all twigs by one factor so that they cover a share of the card, and clears
    /// leaves.
    /// @return the scaled twigs.
    std::vector<TwigPiece> fitTwigs(std::vector<TwigPiece> twigs, float coverage);
    void addLeaf(const LeafOutline& outline, const LeafBlade& blade);
    /// Share of a leaf that would not overlap earlier leaves.
    float freeShare(const LeafOutline& outline, const LeafBlade& blade);
    /// Share of the card that leaves cover, without leaves on top of twigs.
    float leafShare() const;

private:
    static constexpr std::uint8_t leaf = 1, twig = 2;

    void drawTwigs(const std::vector<TwigPiece>& twigs);

    SprayRaster _raster;
    std::vector<std::uint8_t> _parts = std::vector<std::uint8_t>(SprayRaster::size * SprayRaster::size);
    std::size_t _leafSamples = 0;
};

} // namespace osgTreeWind
