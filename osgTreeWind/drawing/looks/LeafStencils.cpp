// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/LeafStencils.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/SharedValues.h>
#include <osgTreeWind/motion/laws/Laws.h>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include <string>

namespace osgTreeWind {
namespace {

constexpr int cells = TreeRaster::cells;

/// Bilinear sample of a mipmap level.
glm::vec4 filtered(const osg::Image& texture, unsigned mipmap, const glm::vec2& at) {
    const int size = std::max(texture.s() >> mipmap, 1);
    const unsigned char* texels = mipmap ? texture.getMipmapData(mipmap) : texture.data();
    const auto texel = [&](int x, int y) {
        const unsigned char* t =
            texels + 4 * (glm::clamp(y, 0, size - 1) * size + glm::clamp(x, 0, size - 1));
        return glm::vec4(t[0], t[1], t[2], t[3]) / 255.0f;
    };
    const glm::vec2 place = at * static_cast<float>(size) - 0.5f, whole = glm::floor(place),
                    part = place - whole;
    const int x = static_cast<int>(whole.x), y = static_cast<int>(whole.y);
    return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), part.x),
                    glm::mix(texel(x, y + 1), texel(x + 1, y + 1), part.x), part.y);
}

/// Ordered dither: thresholds spread evenly over (0, 1) in each 2 x 2 and 4 x 4 block of cells (Bayer 1973).
float threshold(int cell) {
    const int x = cell % cells, y = cell / cells;
    const auto rank = [](int i, int j) { return ((i ^ j) & 1) << 1 | (j & 1); };
    return (static_cast<float>(4 * rank(x, y) + rank(x >> 1, y >> 1)) + 0.5f) / 16.0f;
}

} // namespace

LeafStencils::LeafStencils(const osg::Image& texture, const LeafAtlas::Cell& card)
    : _texels(static_cast<int>(card.size * static_cast<float>(texture.s()))) {
    const auto mipmaps = static_cast<unsigned>(math::log2(static_cast<double>(_texels))) + 1;
    _levels.resize(mipmaps);
    for (std::size_t i = 0; i < _levels.size(); ++i) {
        for (int cell = 0; cell < cells * cells; ++cell) {
            const glm::vec2 at =
                card.at((glm::vec2(cell % cells, cell / cells) + 0.5f) / static_cast<float>(cells));
            const glm::vec4 color = filtered(texture, static_cast<unsigned>(i), at);
            _levels[i].leaves[static_cast<std::size_t>(cell)] = color.a >= threshold(cell);
            _levels[i].twigs[static_cast<std::size_t>(cell)] = color.b >= threshold(cell);
            _levels[i].tints[static_cast<std::size_t>(cell)] = Laws().texelTint(color.r, color.g);
        }
    }
}

std::size_t LeafStencils::chooseLevel(const glm::vec3& across, const glm::vec3& along, float pixel) const {
    const float area = glm::abs(across.x * along.y - across.y * along.x);
    const float widest = glm::max(glm::max(glm::abs(across.x), glm::abs(across.y)),
                                  glm::max(glm::abs(along.x), glm::abs(along.y)));
    const float share = pixel * widest / glm::max(area, 1e-9f); // of the card's width in one pixel
    const float level = math::log2(share * static_cast<float>(_texels)) + 0.5f;
    const auto last = static_cast<float>(_levels.size() - 1);
    return static_cast<std::size_t>(level > 0.0f ? std::min(level, last) : 0.0f);
}

LeafStencils::Atlas LeafStencils::ofAtlas(const osg::Image* texture) {
    static SharedConstants<std::string, std::vector<LeafStencils>> all;
    return all.get(texture->getName(), [&] {
        auto stencils = std::make_shared<std::vector<LeafStencils>>();
        for (int i = 0; i < LeafAtlas::sprays; ++i)
            stencils->emplace_back(*texture, LeafAtlas::spray(i));
        for (const auto& [enlargement, variant] : {std::pair(2, 0), {2, 1}, {3, 0}, {4, 0}})
            stencils->emplace_back(*texture, LeafAtlas::bough(enlargement, variant));
        return stencils;
    });
}

std::size_t LeafStencils::indexOf(int bough, int variant) {
    const int index = bough < 2 ? variant : LeafAtlas::sprays + (bough == 2 ? variant % 2 : bough - 1);
    return static_cast<std::size_t>(index);
}

} // namespace osgTreeWind
