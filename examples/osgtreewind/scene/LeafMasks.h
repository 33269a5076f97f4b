// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/Silhouette.h>
#include <osgTreeWind/drawing/looks/LeafAtlas.h>

#include <array>

namespace osgTreeWind {

/// What of the cards of a leaf texture is solid: leaves with their twigs, and twigs alone.
struct LeafMasks {
    /// @param texture as of makeLeafAtlas().
    explicit LeafMasks(const osg::Image& texture);

    /// Of the cards of sprays.
    const Silhouette::Mask& leaves(int variant) const { return _leaves[static_cast<std::size_t>(variant)]; }
    const Silhouette::Mask& twigs(int variant) const { return _twigs[static_cast<std::size_t>(variant)]; }
    /// Share of a card of sprays that leaves cover without their twigs.
    float leafCoverage() const;

    /// Where alpha of leaves, channel 3, or of twigs, 2, is solid.
    static Silhouette::Mask maskOf(const osg::Image& texture, const LeafAtlas::Cell& cell, int channel);

private:
    std::array<Silhouette::Mask, LeafAtlas::sprays> _leaves, _twigs;
};

} // namespace osgTreeWind
