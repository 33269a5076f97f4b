// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/SprayPieces.h>
#include <osgTreeWind/drawing/looks/SprayRaster.h>

#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// What twigs and leaves hide of the card of a spray, while it grows.
class SprayCover {
public:
    /// Starts with twigs made so wide, by one factor for all, that they cover a share of the card. These it
    /// returns.
    std::vector<TwigPiece> fitTwigs(std::vector<TwigPiece> twigs, float coverage);
    void addLeaf(const LeafOutline& outline, const LeafBlade& blade);
    /// Share of a leaf that would cover none of those before it.
    float freeShare(const LeafOutline& outline, const LeafBlade& blade);
    /// Share of the card that leaves cover, twigs between them left out.
    float leaves() const;

private:
    static constexpr std::uint8_t leaf = 1, twig = 2;

    void drawTwigs(const std::vector<TwigPiece>& twigs);

    SprayRaster _raster;
    std::vector<std::uint8_t> _parts = std::vector<std::uint8_t>(SprayRaster::size * SprayRaster::size);
    std::size_t _leafSamples = 0;
};

} // namespace osgTreeWind
