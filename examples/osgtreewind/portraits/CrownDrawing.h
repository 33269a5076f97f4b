// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/portraits/Silhouette.h>
#include <osgTreeWind/model/TreeModel.h>

#include <glm/geometric.hpp>

/// Draws silhouettes of parts of a tree. `view(point)` projects a point of the tree, metres, to pixels.
namespace osgTreeWind {

/// Calls visit(cluster, quad, corner, across, along) for every quad of every leaf cluster; metres.
template <typename Visit>
void forEachLeafQuad(const TreeModel& model, Visit visit) {
    for (std::size_t cluster = 0; cluster < model.leaves.size(); ++cluster) {
        const LeafCluster& leaf = model.leaves[cluster];
        for (std::size_t i = 0; i < model.leafMesh.size(); i += 4) {
            const auto turned = [&](const glm::vec3& v) { return leaf.size * (leaf.orientation * v); };
            const glm::vec3 corner = model.leafMesh[i].corner;
            visit(cluster, i / 4, leaf.anchor + turned(corner), turned(model.leafMesh[i + 1].corner - corner),
                  turned(model.leafMesh[i + 3].corner - corner));
        }
    }
}

/// Draws a flat piece through a mask. @param mirrored whether `across` runs from right to left on the mask.
template <typename View>
void drawPiece(const View& view, const glm::vec3& corner, const glm::vec3& across, const glm::vec3& along,
               const Silhouette::Mask& mask, Silhouette& silhouette, bool mirrored = false) {
    const glm::vec2 foot = view(corner), right = view(corner + across) - foot,
                    up = view(corner + along) - foot;
    if (mirrored)
        silhouette.draw(foot + right, -right, up, mask);
    else
        silhouette.draw(foot, right, up, mask);
}

/// Draws the wood: units and shoots. @param pixels pixels per metre at a point.
template <typename View, typename Pixels>
void drawWood(const Skeleton& skeleton, const View& view, const Pixels& pixels, Silhouette& silhouette) {
    const Silhouette::Mask solid{1, {1}};
    const auto draw = [&](const glm::vec3& from, const glm::vec3& to, float diameter) {
        const glm::vec2 start = view(from), along = view(to) - start;
        const float length = glm::length(along);
        if (length < 1e-6f)
            return;
        const glm::vec2 side = pixels(from) * diameter * glm::vec2(along.y, -along.x) / length;
        silhouette.draw(start - 0.5f * side, side, along, solid);
    };
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit)
        for (int ring = 0; ring + 1 < skeleton.ringsPerBranch; ++ring)
            draw(skeleton.point(unit, ring), skeleton.point(unit, ring + 1),
                 skeleton.radius(unit, ring) + skeleton.radius(unit, ring + 1));
    for (const Shoot& shoot : skeleton.shoots)
        for (std::size_t i = 0; i + 1 < shoot.count; ++i)
            draw(skeleton.shootPoint(shoot, i), skeleton.shootPoint(shoot, i + 1),
                 shoot.baseRadius + shoot.tipRadius);
}

} // namespace osgTreeWind
