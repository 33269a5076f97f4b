// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/portraits/Silhouette.h>
#include <osgTreeWind/drawing/looks/LeafAtlas.h>

#include <array>

namespace osgTreeWind {

/// Masks of a leaf texture: leaves with their twigs, and twigs alone.
struct LeafMasks {
    /// @param texture made by makeLeafAtlas().
    explicit LeafMasks(const osg::Image& texture);

    /// Masks of the spray cards.
    const Silhouette::Mask& leaves(int variant) const { return _leaves[static_cast<std::size_t>(variant)]; }
    const Silhouette::Mask& twigs(int variant) const { return _twigs[static_cast<std::size_t>(variant)]; }
    /// Share of a spray card that leaves cover, without twigs.
    float leafCoverage() const;

    /// Mask of a cell by its alpha. @param channel 3: leaves; 2: twigs.
    static Silhouette::Mask maskOf(const osg::Image& texture, const LeafAtlas::Cell& cell, int channel);

private:
    std::array<Silhouette::Mask, LeafAtlas::sprays> _leaves, _twigs;
};

} // namespace osgTreeWind
