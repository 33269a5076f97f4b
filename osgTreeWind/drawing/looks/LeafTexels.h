// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec4.hpp>

#include <vector>

namespace osgTreeWind {

/// What a leaf texture holds, row after row from the bottom up, each channel in [0, 1]: brightness, hue (0.5:
/// as the species' leaves), alpha of bare twigs, alpha of leaves and twigs.
struct LeafTexels {
    int size;
    std::vector<glm::vec4> texels;

    explicit LeafTexels(int width) : size(width), texels(static_cast<std::size_t>(width * width)) {}
    glm::vec4& at(int x, int y) { return texels[static_cast<std::size_t>(y * size + x)]; }
    const glm::vec4& at(int x, int y) const { return texels[static_cast<std::size_t>(y * size + x)]; }
};

/// A card, halved again and again down to one texel. Alpha is what leaves, or twigs, cover of a texel; of
/// samples on it as many are to show them (shaders/leaf_texture.glsl): far away the crown is as dense as
/// close by.
std::vector<LeafTexels> leafMipmaps(LeafTexels card);
/// Half as wide.
LeafTexels halved(const LeafTexels& texels);

} // namespace osgTreeWind
