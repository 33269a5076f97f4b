// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec4.hpp>

#include <vector>

namespace osgTreeWind {

/// What a leaf texture holds, row after row from the bottom up, each channel in [0, 1]: brightness, hue (0.5:
/// as the species' leaves), alpha of bare twigs, alpha of leaves and twigs.
struct LeafTexels {
    static constexpr float alphaThreshold = 0.5f; ///< As shaders/leaf.frag tests it.

    int size;
    std::vector<glm::vec4> texels;

    explicit LeafTexels(int width) : size(width), texels(static_cast<std::size_t>(width * width)) {}
    glm::vec4& at(int x, int y) { return texels[static_cast<std::size_t>(y * size + x)]; }
    const glm::vec4& at(int x, int y) const { return texels[static_cast<std::size_t>(y * size + x)]; }
};

/// A card, halved again and again down to one texel, for filters that take the nearest level. On each the
/// alpha test keeps as much of leaves, and of twigs, as they cover, everywhere on the card: far away the
/// crown is as dense and as finely cut as close by.
std::vector<LeafTexels> leafMipmaps(LeafTexels card);
/// Half as wide.
LeafTexels halved(const LeafTexels& texels);

} // namespace osgTreeWind
