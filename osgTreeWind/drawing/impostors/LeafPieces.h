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

/// A quad of a leaf cluster with the colour, light and normal that shaders/instance_leaf.vert gives it.
struct LeafPiece {
    glm::vec3 corner, across, along; ///< Metres, tree's frame.
    glm::vec3 color;
    CrownShade::Light light;
    glm::vec3 blade, normal; ///< Geometric normal; normal for lighting.
    bool borne;              ///< Whether it has leaves; else bare twigs.
    std::size_t stencils;    ///< Index into LeafStencils::ofAtlas().
};

/// The quads of all leaf clusters of a tree. @param share of the leaves that the tree bears.
std::vector<LeafPiece> leafPieces(const ThinnedLeaves& leaves,
                                  const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                                  const CrownShade& crown, const Appearance& appearance, float share);

/// Draws leaves to a raster, each with the stencil level for its size.
class LeafRasterizer {
public:
    /// @param pieces, stencils of LeafStencils::ofAtlas(); both must outlive this object.
    LeafRasterizer(const std::vector<LeafPiece>& pieces, const std::vector<LeafStencils>& stencils)
        : _pieces(pieces), _stencils(stencils), _levels(pieces.size()) {}

    /// Draws all pieces; the item of a sample is the index of its piece. @param scale, shift from metres in
    /// the view to samples. @param pixel size of a pixel, metres.
    void draw(const TreeView& view, const glm::vec3& scale, const glm::vec3& shift, float pixel,
              TreeRaster& raster);
    /// The leaf tint at a sample.
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

/// Mean luminance of the visible leaves of a tree in the light of a typical day (MeanLight), seen from its
/// sides; 0 without visible leaves.
/// @param stencils LeafStencils::ofAtlas() of the leaves. @param height of the tree, metres.
float visibleLeafLight(const std::vector<LeafPiece>& pieces, const std::vector<LeafStencils>& stencils,
                       const Appearance& appearance, float height);

} // namespace osgTreeWind
