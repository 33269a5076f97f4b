// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/LeafTexels.h>

#include <osg/Image>

#include <glm/vec2.hpp>

#include <array>

namespace osgTreeWind {

/// Layout of a leaf texture: cards of three sprays, and in the last quarter cards of boughs. A bough replaces
/// a spray on an enlarged card and holds more sprays, so that the leaves keep their size.
struct LeafAtlas {
    static constexpr int sprays = 3;

    /// A square part of the texture.
    struct Cell {
        glm::vec2 low{0.0f};
        float size = 1.0f;

        glm::vec2 at(const glm::vec2& onCard) const { return low + size * onCard; }
    };

    static Cell spray(int variant);
    /// @param enlargement 2, 3 or 4. @param variant 0 or 1 for an enlargement of 2; else not used.
    static Cell bough(int enlargement, int variant = 0);

    /// The spray of a quad, which differs between neighbouring quads and clusters.
    struct Choice {
        int variant;
        bool mirrored;
    };
    static Choice choose(std::size_t cluster, std::size_t quad);
    /// Texture coordinate of a point on a quad of a cluster. @param onCard in [0, 1].
    static glm::vec2 sprayCoordinate(std::size_t cluster, std::size_t quad, const glm::vec2& onCard);
    /// Texture coordinate of a point on the bough card of a cluster. @param onCard in [0, 1].
    static glm::vec2 boughCoordinate(int enlargement, std::size_t cluster, const glm::vec2& onCard);
};

/// Makes the leaf texture as RGBA8 with a complete mipmap chain; each card has the levels of leafMipmaps().
/// @param sparse, onRibs see paintBough().
osg::ref_ptr<osg::Image> makeLeafAtlas(const std::array<LeafTexels, LeafAtlas::sprays>& sprays,
                                       const std::vector<LeafTexels>& sparse, bool onRibs = false);

} // namespace osgTreeWind
