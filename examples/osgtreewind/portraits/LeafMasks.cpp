// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/portraits/LeafMasks.h>

namespace osgTreeWind {

LeafMasks::LeafMasks(const osg::Image& texture) {
    for (int i = 0; i < LeafAtlas::sprays; ++i) {
        _leaves[static_cast<std::size_t>(i)] = maskOf(texture, LeafAtlas::spray(i), 3);
        _twigs[static_cast<std::size_t>(i)] = maskOf(texture, LeafAtlas::spray(i), 2);
    }
}

float LeafMasks::leafCoverage() const {
    std::size_t leaves = 0, all = 0;
    for (std::size_t i = 0; i < LeafAtlas::sprays; ++i)
        for (std::size_t j = 0; j < _leaves[i].solid.size(); ++j, ++all)
            leaves += _leaves[i].solid[j] && !_twigs[i].solid[j];
    return static_cast<float>(leaves) / static_cast<float>(all);
}

Silhouette::Mask LeafMasks::maskOf(const osg::Image& texture, const LeafAtlas::Cell& cell, int channel) {
    const auto texels = static_cast<float>(texture.s());
    const glm::ivec2 low = glm::ivec2(cell.low * texels);
    Silhouette::Mask mask;
    mask.size = static_cast<int>(cell.size * texels);
    for (int y = 0; y < mask.size; ++y)
        for (int x = 0; x < mask.size; ++x)
            mask.solid.push_back(texture.data()[4 * ((low.y + y) * texture.s() + low.x + x) + channel] >
                                 32 + 64 * ((2 * y + 3 * (x ^ y)) & 3)); // keeps the mean of thin twigs
    return mask;
}

} // namespace osgTreeWind
