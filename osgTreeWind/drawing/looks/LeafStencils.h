// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/TreeRaster.h>

#include <osg/Image>

#include <vector>

namespace osgTreeWind {

/// A leaf texture as the graphics card shows it from far away: filtered, then tested for alpha.
class LeafStencils {
public:
    struct Level {
        TreeRaster::Stencil leaves, twigs;                                  ///< In leaf, and bare.
        std::array<glm::vec3, TreeRaster::cells * TreeRaster::cells> tints; ///< Of leaves.
    };

    /// @param texture RGBA with all its mipmaps, square.
    explicit LeafStencils(const osg::Image& texture);

    /// @param share of the texture's width that a pixel of the picture takes.
    std::size_t levelOf(float share) const;
    const Level& level(std::size_t index) const { return _levels[index]; }

private:
    static constexpr int steps = 2; ///< Levels to a mipmap.
    int _texels;
    std::vector<Level> _levels;
};

} // namespace osgTreeWind
