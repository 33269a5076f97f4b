// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafTexels.h>

#include <osg/Image>

#include <glm/vec2.hpp>

#include <array>

namespace osgTreeWind {

/// Where cards lie in a leaf texture: three sprays, and in its last quarter boughs, which bear as many sprays
/// as fill a card that is enlarged, so that leaves keep their size.
struct LeafAtlas {
    static constexpr int sprays = 3;

    /// A square part of the texture.
    struct Cell {
        glm::vec2 low{0.0f};
        float size = 1.0f;

        glm::vec2 at(const glm::vec2& onCard) const { return low + size * onCard; }
    };

    static Cell spray(int variant);
    /// Of cards so many times enlarged, 2, 3 or 4; of 2 there are two.
    static Cell bough(int growth, int variant = 0);

    /// The spray on a quad of a cluster, and whether it is seen from behind, so that no two neighbours are
    /// alike.
    struct Choice {
        int variant;
        bool mirrored;
    };
    static Choice choose(std::size_t cluster, std::size_t quad);
    /// In the texture, of a point on that quad.
    static glm::vec2 coordinate(std::size_t cluster, std::size_t quad, const glm::vec2& onCard);
    /// In the texture, of a point on a bough that stands for a cluster and others.
    static glm::vec2 onBough(int growth, std::size_t cluster, const glm::vec2& onCard);
};

/// As RGBA8 with levels down to one texel, those of each card as leafMipmaps() has them.
/// @param sparse what boughs are painted of. @param onRibs as of paintBough().
osg::ref_ptr<osg::Image> makeLeafAtlas(const std::array<LeafTexels, LeafAtlas::sprays>& sprays,
                                       const std::vector<LeafTexels>& sparse, bool onRibs = false);

} // namespace osgTreeWind
