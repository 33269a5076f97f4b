// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/impostors/LeafPieces.h>

#include <osgTreeWind/base/Luminance.h>
#include <osgTreeWind/motion/laws/Laws.h>

#include <glm/common.hpp>

namespace osgTreeWind {

std::vector<LeafPiece> leafPieces(const ThinnedLeaves& leaves,
                                  const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                                  const CrownShade& crown, const Appearance& appearance, float share) {
    std::vector<LeafPiece> pieces;
    pieces.reserve(leaves.clusters.size() * static_cast<std::size_t>(leaves.quads()));
    for (std::size_t i = 0; i < leaves.clusters.size(); ++i) {
        const LeafCluster& leaf = leaves.clusters[i];
        const std::size_t own = leaves.indices[i];
        const bool borne = isClusterBorne(own, share);
        const auto first = static_cast<std::size_t>(leaves.firstQuad(i));
        const glm::vec3 outward = crown.outward(leaf.anchor);
        const CrownShade::Light light = crown.at(leaves.middle(i, mesh));
        const glm::vec3 color = borne ? Laws().clusterTint(0.0f, static_cast<float>(own)) * appearance.leaves
                                      : appearance.twigColor();
        for (std::size_t quad = first; quad < first + static_cast<std::size_t>(leaves.quads()); ++quad) {
            const auto turned = [&](const glm::vec3& v) { return leaf.size * (leaf.orientation * v); };
            const glm::vec3 corner = mesh[4 * quad].corner, blade = leaf.orientation * mesh[4 * quad].normal;
            const float side = glm::sign(glm::dot(blade, outward));
            const auto [variant, mirrored] = LeafAtlas::choose(own, leaves.bough > 1 ? 0 : quad);
            const glm::vec3 across = turned(mesh[4 * quad + 1].corner - corner);
            pieces.push_back({leaf.anchor + turned(corner) + (mirrored ? across : glm::vec3(0.0f)),
                              mirrored ? -across : across, turned(mesh[4 * quad + 3].corner - corner), color,
                              light, blade, glm::normalize(outward + 0.5f * side * blade), borne,
                              LeafStencils::indexOf(leaves.bough, variant)});
        }
    }
    return pieces;
}

void LeafRasterizer::draw(const TreeView& view, const glm::vec3& scale, const glm::vec3& shift, float pixel,
                          TreeRaster& raster) {
    for (std::size_t item = 0; item < _pieces.size(); ++item) {
        const LeafPiece& piece = _pieces[item];
        const glm::vec3 across = view(piece.across), along = view(piece.along);
        const std::size_t seen = _stencils[piece.stencils].chooseLevel(across, along, pixel);
        _levels[item] = static_cast<std::uint8_t>(seen);
        raster.draw({scale * view(piece.corner) + shift, scale * across, scale * along},
                    piece.borne ? level(item).leaves : level(item).twigs, static_cast<std::uint32_t>(item));
    }
}

float visibleLeafLight(const std::vector<LeafPiece>& pieces, const std::vector<LeafStencils>& stencils,
                       const Appearance& appearance, float height) {
    constexpr int samples = 96, views = 3;
    const float scale = static_cast<float>(samples) / height;
    LeafRasterizer picture(pieces, stencils);
    TreeRaster raster(samples);
    float sum = 0.0f;
    int count = 0;
    for (int i = 0; i < views; ++i) {
        const TreeView view(6.2831853f * static_cast<float>(i) / views, 0.15f);
        raster.clear();
        picture.draw(view, {scale, scale, 1.0f}, {0.5f * samples, 0.0f, 0.0f}, 1.0f / scale, raster);
        for (int y = 0; y < samples; ++y)
            for (int x = 0; x < samples; ++x)
                if (const TreeRaster::Sample& sample = raster.sample(x, y);
                    sample.item != TreeRaster::nothing) {
                    const LeafPiece& piece = pieces[sample.item];
                    const float side = glm::dot(piece.blade, view.toEye) < 0.0f ? appearance.underside : 1.0f;
                    sum += side * luminance(picture.tint(sample)) *
                           MeanLight::on(piece.light, piece.normal, true);
                    ++count;
                }
    }
    return count > 0 ? sum / static_cast<float>(count) : 0.0f;
}

} // namespace osgTreeWind
