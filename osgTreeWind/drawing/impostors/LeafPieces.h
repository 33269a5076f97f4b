// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/LightLobe.h>
#include <osgTreeWind/drawing/impostors/TreeView.h>
#include <osgTreeWind/drawing/looks/LeafStencils.h>
#include <osgTreeWind/model/TreeDetail.h>
#include <osgTreeWind/species/Appearance.h>

#include <cstdint>
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

/// Leaves in a picture, and the level of its stencil that each is drawn at.
class LeafPicture {
public:
    /// @param pieces, stencils LeafStencils::ofAtlas() of the leaves; both outlive this.
    LeafPicture(const std::vector<LeafPiece>& pieces, const std::vector<LeafStencils>& stencils)
        : _pieces(pieces), _stencils(stencils), _levels(pieces.size()) {}

    /// Draws them, a piece an item. @param scale, shift from the view, metres, to samples. @param pixel
    /// metres of a pixel that shows them.
    void draw(const TreeView& view, const glm::vec3& scale, const glm::vec3& shift, float pixel,
              TreeRaster& raster);
    /// What is painted at a sample.
    glm::vec3 tint(const TreeRaster::Sample& sample) const {
        return level(sample.item).tints[static_cast<std::size_t>(sample.cell)];
    }

private:
    const LeafStencils::Level& level(std::size_t item) const {
        return _stencils[_pieces[item].stencils].level(_levels[item]);
    }
    const std::vector<LeafPiece>& _pieces;
    const std::vector<LeafStencils>& _stencils;
    std::vector<std::uint8_t> _levels;
};

/// Light of a usual day (MeanLight) on the leaves that are seen of a tree from its sides.
/// @param stencils LeafStencils::ofAtlas() of its leaves. @param height of the tree, metres. 0 where no leaf
/// is seen.
float seenLeafLight(const std::vector<LeafPiece>& pieces, const std::vector<LeafStencils>& stencils,
                    const Appearance& appearance, float height);

} // namespace osgTreeWind
