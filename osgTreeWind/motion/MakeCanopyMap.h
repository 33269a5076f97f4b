// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/wind/CanopyMap.h>
#include <osgTreeWind/wind/CanopySettings.h>

#include <glm/vec2.hpp>

#include <array>
#include <memory>
#include <vector>

namespace osgTreeWind {

/// A tree's contribution to the canopy around it.
struct CanopyTree {
    static constexpr std::size_t layers = 8;

    glm::vec2 place{0.0f};            ///< Metres.
    float height = 0.0f;              ///< Metres.
    float crownArea = 0.0f;           ///< Projected crown area, m^2.
    float frontalArea = 0.0f;         ///< Half the leaf area plus the side view of the wood, m^2.
    std::array<float, layers> drag{}; ///< Half CdA by eighths of the height, m^2.
    float streamlining = 0.0f;        ///< Exponent of the total drag from 10 m/s to `streamlinedTo`.
    float streamlinedTo = 25.0f;      ///< m/s
    float breezeStreamlining = 0.0f;  ///< Exponent below 10 m/s.

    CanopyTree() = default;
    CanopyTree(const PlacedForest& forest, const PlacedTree& tree);
};

/// Maps the stands that trees form around each other.
///
/// A stand takes no more momentum out of the air than flows down into it: where crowns would take more, they
/// shelter each other until the mean drag of the trees per ground area is rho u*^2. This is solved for each
/// wind speed, since crowns streamline. If `canopy` gives its reach, its mean stand and its extent, the value
/// at a place depends, to the bit, only on the trees within shelterReach() of it.
/// @param canopy with CanopySource::Given, the map is a single uniform stand.
std::shared_ptr<CanopyMap> makeCanopyMap(const std::vector<CanopyTree>& trees,
                                         const CanopySettings& canopy = {});

/// An unbounded uniform stand with the drag profile of these trees. @param height of the stand, metres.
/// @param frontalArea frontal area index, m^2 per m^2 of ground.
std::shared_ptr<CanopyMap> makeUniformCanopyMap(const std::vector<CanopyTree>& trees, float height,
                                                float frontalArea);

/// The drag of a stand by height.
struct StandLeaves {
    float height = 0.0f; ///< Metres; 0 without trees.
    /// Force over the squared mean wind, per ground area, in equal layers from the ground up.
    std::vector<float> drag;
};
/// The mean stand around the leaves of a forest.
StandLeaves meanStandOf(const std::vector<CanopyTree>& trees);

/// Fills in the reach, the mean stand, the extent and the reference height of a whole forest, so that each
/// tile uses the statistics of all tiles. @param parts trees of sample areas that represent the forest.
/// @param trees number of trees in the whole forest.
CanopySettings withCanopyStatistics(CanopySettings canopy, const std::vector<std::vector<CanopyTree>>& parts,
                                    std::size_t trees);

/// Distance up to which trees influence the wind at other trees, metres. @param canopy with a reach.
double shelterReach(const CanopySettings& canopy);

} // namespace osgTreeWind
