// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/DrawingOptions.h>
#include <osgTreeWind/forest/ForestTiles.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/places/Ground.h>
#include <osgTreeWind/species/Season.h>
#include <osgTreeWind/species/Species.h>
#include <osgTreeWind/wind/Wind.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The law by which wind moves branches (docs/frame.md, docs/thesis.md).
enum class MotionLaw {
    Thesis,       ///< Appendix B as published: no restoring force, one step a frame.
    ThesisSmooth, ///< The text of §3.1: partial steps and the level term.
    Modal,        ///< The whole tree coupled, swaying in a few modes; SI units and seconds.
};

/// One tree: which species, where, how large. check() says what is out of range.
struct TreePlacement {
    std::size_t species = 0; ///< Index into ForestDescription::species.
    /// Foot of the trunk in world coordinates, metres (x east, y north, z up): each within 1e8, and together
    /// at most 100 km from the origin, where the floats of geometry still resolve 8 mm.
    glm::dvec3 position{0.0};
    float heading =
        0.0f;      ///< Turn about the vertical, radians, counter-clockwise from above; within 1e6 degrees.
    TreeSize size; ///< A crown not given follows the trunk, other sizes follow the model.
    float leaves = 1.0f;    ///< Share of its leaves that it bears in summer, 0 (bare) to 1.
    std::uint32_t seed = 0; ///< Picks one of the species' shapes, and the noise streams.
    bool openGrown = false; ///< Stands by itself: such a crown is wider and deeper than in a forest.
    /// Stands at the edge of a wood, which is open where its heading points.
    bool atEdge = false;
    std::string name{};         ///< An inventory's id; empty: none. Where two have one, it is the first's.
    EstimatedSizes estimated{}; ///< Of `size`.
    bool tiled = false;         ///< Came with a tile, and goes with it: no file says it.
};

/// A whole forest as plain values: what a .treewind file says. check() says what is out of range.
struct ForestDescription {
    std::vector<Species> species;     ///< That trees are of, by index.
    std::vector<TreePlacement> trees; ///< In the order that ids go by.
    std::optional<ForestTiles> tiles; ///< More trees, which come and go; under the law `modal`.
    /// World position of the scene's origin, metres, each within 1e8; geometry is relative to it.
    glm::dvec3 origin{0.0};
    /// What world coordinates are of: a map in metres, in any words that PROJ knows ("EPSG:25832"). Empty:
    /// none.
    std::string crs;
    /// The map that a host's scene is in, likewise; empty: none. A reader of models puts the forest where it
    /// stands there (placeOnHostMap()).
    std::string hostCrs;
    GroundPtr ground; ///< Null: none. Trees stand where they are put (StandOnGround.h puts them on it).
    MotionLaw law = MotionLaw::Modal; ///< How they move.
    /// On the answer of `modal`: 1 is physical, more is an exaggeration for the eye, [0, 100].
    float gain = 1.0f;
    /// Whether the wind brings down trees that it pulls at beyond what roots and stems bear, and in autumn
    /// leaves that hang loose; `modal` alone.
    bool damage = false;
    /// beta of 1/f^beta noise for leaves and for the load of the thesis' laws, [0, 3]; none: Perlin noise.
    std::optional<float> noiseExponent;
    Wind wind; ///< That moves them; its canopy is that of every wind the forest is given later.
    float season = midsummer; ///< Of the year (Season.h).
    /// How long a frame of a viewer lasts, seconds, whatever time the viewer gives, [0, 60]; 0: its time
    /// counts.
    double step = 0.0;
    DrawingOptions drawing; ///< How they are drawn.

    bool crsChosen = false;         ///< `crs` is what an inventory asked for, the file does not say it.
    std::vector<std::string> notes; ///< What a person should know about how the input was taken.
    std::string source; ///< Text of the .treewind file it was read from; empty for one made by hand.
    std::string folder; ///< Absolute folder against which paths in `source` resolve.
};

} // namespace osgTreeWind
