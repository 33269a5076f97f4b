// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

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

    /// Share of texels that the alpha test keeps when a channel is multiplied by `scale`.
    float coverage(int channel, float scale = 1.0f) const;
};

/// As RGBA8 with all levels down to one texel. On each the alpha test keeps that share of leaves, and of
/// twigs, which they cover: the crown stays as dense far away as close by (Castaño, "Computing alpha
/// mipmaps", 2010).
osg::ref_ptr<osg::Image> makeLeafImage(LeafTexels texels);

} // namespace osgTreeWind
