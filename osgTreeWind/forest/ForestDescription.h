// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/DrawingOptions.h>
#include <osgTreeWind/forest/ForestTiles.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/places/Ground.h>
#include <osgTreeWind/species/Season.h>
#include <osgTreeWind/species/Species.h>
#include <osgTreeWind/wind/CanopySettings.h>
#include <osgTreeWind/wind/Wind.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The law by which wind moves branches (docs/frame.md, docs/thesis.md).
enum class MotionLaw {
    Thesis,       ///< Appendix B as published: no restoring force, one step per frame.
    ThesisSmooth, ///< The text of §3.1: partial steps and the level term.
    Modal,        ///< Modal dynamics of the whole tree, in SI units and seconds.
};

/// Species, position and size of one tree. check() validates it.
struct TreePlacement {
    std::size_t species = 0; ///< Index into ForestDescription::species.
    /// Foot of the trunk in world coordinates, metres (x east, y north, z up): each within 1e8, and at most
    /// 100 km from the origin, where the floats of geometry still resolve 8 mm.
    glm::dvec3 position{0.0};
    /// Rotation about the vertical, radians, counter-clockwise from above; within 1e6 degrees.
    float heading = 0.0f;
    TreeSize size;       ///< A missing crown width follows the trunk; other missing sizes follow the model.
    float leaves = 1.0f; ///< Share of its leaves that the tree bears in summer, 0 (bare) to 1.
    std::uint32_t seed = 0; ///< Selects one of the species' shapes and the noise streams.
    /// Stands free; the crown is wider and deeper, and the trunk thicker, than in a forest. Only readers of
    /// files decide this from the neighbours.
    bool openGrown = false;
    bool atEdge = false;        ///< Stands at the edge of a forest that is open toward `heading`.
    std::string name{};         ///< Id in an inventory; may be empty. Of equal names, only the first counts.
    EstimatedSizes estimated{}; ///< Which members of `size` an inventory's reader has estimated.
    bool tiled = false;         ///< Belongs to a loaded tile. Not part of any file.
};

/// A whole forest as plain values: the content of a .treewind file. check() validates it.
struct ForestDescription {
    std::vector<Species> species;     ///< Referenced by index.
    std::vector<TreePlacement> trees; ///< Tree ids follow this order.
    std::optional<ForestTiles> tiles; ///< Further trees, loaded on demand; law `modal` only.
    /// World position of the scene's origin, metres, each within 1e8; geometry is relative to it.
    glm::dvec3 origin{0.0};
    /// Projected CRS of the world in metres, in any form that PROJ accepts ("EPSG:25832"); may be empty.
    std::string crs;
    /// CRS of the host's scene, in the same form; may be empty. OSG's model reader then places the forest in
    /// that scene (hostMapTransform()).
    std::string hostCrs;
    GroundPtr ground;                 ///< May be null. Trees are placed on it only by StandOnGround.h.
    MotionLaw law = MotionLaw::Modal; ///< How wind moves the trees.
    /// Factor on the motion under `modal`, [0, 100]; 1 is physical, more exaggerates.
    float gain = 1.0f;
    /// Whether wind can uproot and break trees and blow loose autumn leaves off; law `modal` only.
    bool damage = false;
    /// beta of 1/f^beta noise for leaves and for the load of the thesis' laws, [0, 3]; empty: Perlin noise.
    std::optional<float> noiseExponent;
    Wind wind;                ///< The first wind.
    CanopySettings canopy;    ///< How the trees change every wind.
    float season = midsummer; ///< Time of year (Season.h).
    /// Simulated time per frame, seconds, [0, 60]; 0: the viewer's time.
    double step = 0.0;
    DrawingOptions drawing; ///< How the trees are drawn.

    std::string folder; ///< Absolute folder of the file it was read from, for relative paths; may be empty.
};

} // namespace osgTreeWind
