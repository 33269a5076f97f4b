// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/LightLobe.h>
#include <osgTreeWind/drawing/looks/LeafStencils.h>
#include <osgTreeWind/model/TreeDetail.h>
#include <osgTreeWind/species/Appearance.h>

#include <vector>

namespace osgTreeWind {

/// A quad of a leaf cluster, and what shaders/instance_leaf.vert makes of it.
struct LeafPiece {
    glm::vec3 corner, across, along; ///< Metres, tree frame.
    glm::vec3 color;
    CrownShade::Light light;
    glm::vec3 blade, normal; ///< Of the quad, and the one that it is lit by.
    bool borne;              ///< Or bare twigs.
    std::size_t stencils;    ///< Of LeafStencils::ofAtlas().
};

/// @param share of the leaves that the tree bears.
std::vector<LeafPiece> leafPieces(const ThinnedLeaves& leaves,
                                  const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                                  const CrownShade& crown, const Appearance& appearance, float share);

/// Light of a usual day (MeanLight) on the leaves that are seen of a tree from its sides.
/// @param stencils LeafStencils::ofAtlas() of its leaves. @param height of the tree, metres. 0 where no leaf
/// is seen.
float seenLeafLight(const std::vector<LeafPiece>& pieces, const std::vector<LeafStencils>& stencils,
                    const Appearance& appearance, float height);

} // namespace osgTreeWind
