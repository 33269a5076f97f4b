// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/LeafAtlas.h>

#include <osgTreeWind/drawing/looks/BoughCard.h>
#include <osgTreeWind/drawing/looks/ByteOf.h>

#include <algorithm>

namespace osgTreeWind {
namespace {

void copyCard(const LeafTexels& card, const LeafAtlas::Cell& cell, LeafTexels& level) {
    const glm::ivec2 low = glm::ivec2(cell.low * static_cast<float>(level.size));
    for (int y = 0; y < card.size; ++y)
        for (int x = 0; x < card.size; ++x)
            level.at(low.x + x, low.y + y) = card.at(x, y);
}

glm::vec2 mirroredPoint(const LeafAtlas::Choice& choice, const glm::vec2& onCard) {
    return {choice.mirrored ? 1.0f - onCard.x : onCard.x, onCard.y};
}

} // namespace

LeafAtlas::Cell LeafAtlas::spray(int variant) {
    return {0.5f * glm::vec2(variant % 2, variant / 2), 0.5f}; // NOLINT(bugprone-integer-division)
}

LeafAtlas::Cell LeafAtlas::bough(int enlargement, int variant) {
    const int cell = enlargement == 2 ? variant % 2 : enlargement - 1;
    return {0.5f + 0.25f * glm::vec2(cell % 2, cell / 2), 0.25f}; // NOLINT(bugprone-integer-division)
}

LeafAtlas::Choice LeafAtlas::choose(std::size_t cluster, std::size_t quad) {
    const std::size_t place = cluster * 7 + quad * 5;
    return {static_cast<int>((cluster + quad) % sprays), (place / 3) % 2 == 1};
}

glm::vec2 LeafAtlas::sprayCoordinate(std::size_t cluster, std::size_t quad, const glm::vec2& onCard) {
    const Choice choice = choose(cluster, quad);
    return spray(choice.variant).at(mirroredPoint(choice, onCard));
}

glm::vec2 LeafAtlas::boughCoordinate(int enlargement, std::size_t cluster, const glm::vec2& onCard) {
    const Choice choice = choose(cluster, 0);
    return bough(enlargement, choice.variant).at(mirroredPoint(choice, onCard));
}

osg::ref_ptr<osg::Image> makeLeafAtlas(const std::array<LeafTexels, LeafAtlas::sprays>& sprays,
                                       const std::vector<LeafTexels>& sparse, bool onRibs) {
    std::vector<std::pair<LeafAtlas::Cell, std::vector<LeafTexels>>> cells;
    for (int i = 0; i < LeafAtlas::sprays; ++i)
        cells.emplace_back(LeafAtlas::spray(i), leafMipmaps(sprays[static_cast<std::size_t>(i)]));
    for (const auto& [enlargement, variant] : {std::pair(2, 0), {2, 1}, {3, 0}, {4, 0}})
        cells.emplace_back(LeafAtlas::bough(enlargement, variant),
                           leafMipmaps(paintBough(sparse, sprays.front(), enlargement, variant, onRibs)));
    const int size = 2 * sprays.front().size;
    std::vector<unsigned char> bytes;
    osg::Image::MipmapDataType offsets;
    LeafTexels level(size);
    for (std::size_t i = 0;; ++i) {
        for (const auto& [cell, levels] : cells)
            if (i < levels.size())
                copyCard(levels[i], cell, level);
        for (const glm::vec4& texel : level.texels)
            for (int channel = 0; channel < 4; ++channel)
                bytes.push_back(byteOf(texel[channel]));
        if (level.size == 1)
            break;
        offsets.push_back(static_cast<unsigned>(bytes.size()));
        level = halved(level);
    }
    auto* data = new unsigned char[bytes.size()];
    std::copy(bytes.begin(), bytes.end(), data);
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setImage(size, size, 1, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, data, osg::Image::USE_NEW_DELETE);
    image->setMipmapLevels(offsets);
    return image;
}

} // namespace osgTreeWind
