// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec4.hpp>

#include <vector>

namespace osgTreeWind {

/// A square leaf image, row by row from the bottom. Channels, each in [0, 1]: brightness, hue (0.5: the
/// species' leaf colour), alpha of bare twigs, alpha of leaves with twigs.
struct LeafTexels {
    int size;
    std::vector<glm::vec4> texels;

    explicit LeafTexels(int width) : size(width), texels(static_cast<std::size_t>(width * width)) {}
    glm::vec4& at(int x, int y) { return texels[static_cast<std::size_t>(y * size + x)]; }
    const glm::vec4& at(int x, int y) const { return texels[static_cast<std::size_t>(y * size + x)]; }
};

/// The mipmap levels of a card down to one texel. Alpha is the covered share of a texel, and the share of
/// samples that shaders/leaf_texture.glsl draws, so that crowns are equally dense at all distances.
std::vector<LeafTexels> leafMipmaps(LeafTexels card);
/// The next mipmap level, half as wide.
LeafTexels halved(const LeafTexels& texels);

} // namespace osgTreeWind
