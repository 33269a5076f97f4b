// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/LeafTexels.h>

#include <utility>

namespace osgTreeWind {

LeafTexels halved(const LeafTexels& level) {
    LeafTexels half(level.size / 2);
    for (int y = 0; y < half.size; ++y)
        for (int x = 0; x < half.size; ++x) {
            glm::vec4 sum(0.0f), plain(0.0f);
            for (int i = 0; i < 4; ++i) {
                const glm::vec4& texel = level.at(2 * x + i % 2, 2 * y + i / 2);
                const float weight = texel.a + 1e-3f; // empty texels do not affect colours
                sum += glm::vec4(weight * texel.r, weight * texel.g, texel.b, texel.a);
                plain += glm::vec4(weight);
            }
            half.at(x, y) = {sum.r / plain.r, sum.g / plain.r, 0.25f * sum.b, 0.25f * sum.a};
        }
    return half;
}

std::vector<LeafTexels> leafMipmaps(LeafTexels card) {
    std::vector<LeafTexels> levels{std::move(card)};
    while (levels.back().size > 1)
        levels.push_back(halved(levels.back()));
    return levels;
}

} // namespace osgTreeWind
