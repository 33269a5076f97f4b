// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafAtlas.h>
#include <osgTreeWind/drawing/looks/TreeRaster.h>

#include <osg/Image>

#include <memory>
#include <vector>

namespace osgTreeWind {

/// A card of a leaf texture as the graphics card shows it from far away: filtered, and solid on as many of
/// its cells as it covers.
class LeafStencils {
public:
    struct Level {
        TreeRaster::Stencil leaves, twigs;                                  ///< In leaf, and bare.
        std::array<glm::vec3, TreeRaster::cells * TreeRaster::cells> tints; ///< Of leaves.
    };

    /// @param texture as of makeLeafAtlas(). @param cell of it.
    LeafStencils(const osg::Image& texture, const LeafAtlas::Cell& cell);
    /// Of all sprays and boughs of a texture; the same ones for all who hold them. Any thread.
    using Atlas = std::shared_ptr<const std::vector<LeafStencils>>;
    static Atlas ofAtlas(const osg::Image* texture);
    /// Among them. @param bough as of TreeDetail. @param variant of LeafAtlas::choose().
    static std::size_t indexOf(int bough, int variant);

    /// As finely as a card is seen. @param across, along its sides in the view, x and y in the unit of
    /// `pixel`.
    /// @param pixel of the picture.
    std::size_t levelOf(const glm::vec3& across, const glm::vec3& along, float pixel) const;
    const Level& level(std::size_t index) const { return _levels[index]; }

private:
    int _texels;
    std::vector<Level> _levels;
};

} // namespace osgTreeWind
