// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafAtlas.h>
#include <osgTreeWind/drawing/looks/TreeRaster.h>

#include <osg/Image>

#include <memory>
#include <vector>

namespace osgTreeWind {

/// Stencils of a card of a leaf texture at each mipmap level, as the GPU draws it: filtered, with a share of
/// solid cells that equals its coverage.
class LeafStencils {
public:
    struct Level {
        TreeRaster::Stencil leaves, twigs;                                  ///< In leaf; bare.
        std::array<glm::vec3, TreeRaster::cells * TreeRaster::cells> tints; ///< Of leaves, by cell.
    };

    /// @param texture result of makeLeafAtlas(). @param cell of a card.
    LeafStencils(const osg::Image& texture, const LeafAtlas::Cell& cell);
    /// Stencils of all sprays and boughs of a leafImage(), shared while they are in use. Any thread.
    using Atlas = std::shared_ptr<const std::vector<LeafStencils>>;
    static Atlas ofAtlas(const osg::Image* texture);
    /// Index into an Atlas. @param bough see TreeDetail. @param variant of LeafAtlas::choose().
    static std::size_t indexOf(int bough, int variant);

    /// The mipmap level for a card in a view. @param across, along sides of the card in the view; x and y in
    /// the unit of `pixel`. @param pixel size of a pixel of the picture.
    std::size_t chooseLevel(const glm::vec3& across, const glm::vec3& along, float pixel) const;
    const Level& level(std::size_t index) const { return _levels[index]; }

private:
    int _texels;
    std::vector<Level> _levels;
};

} // namespace osgTreeWind
