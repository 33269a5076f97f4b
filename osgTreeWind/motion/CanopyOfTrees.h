// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/species/Species.h>
#include <osgTreeWind/wind/CanopyMap.h>
#include <osgTreeWind/wind/WindCanopy.h>

#include <glm/vec2.hpp>

#include <array>
#include <memory>
#include <vector>

namespace osgTreeWind {

/// What one tree is to the stand around it.
struct CanopyTree {
    static constexpr std::size_t layers = 8;

    glm::vec2 place{0.0f};            ///< Metres.
    float height = 0.0f;              ///< Metres.
    float crownArea = 0.0f;           ///< Ground under its crown, m^2.
    float frontalArea = 0.0f;         ///< Half of its leaf area, and its wood seen from the side, m^2.
    std::array<float, layers> drag{}; ///< Half CdA by eighths of its height, m^2.
    float streamlining = 0.0f;        ///< Exponent of all of its drag from 10 m/s on, up to
    float streamlinedTo = 25.0f;      ///< m/s,
    float breezeStreamlining = 0.0f;  ///< and below 10 m/s.

    CanopyTree() = default;
    CanopyTree(const TreeModel& model, const TreeScale& scale, const Species& species, float leaves,
               const glm::vec2& at);
};

/// The stands that these trees make around each other.
///
/// A stand takes no more momentum out of the air than flows down into it: where crowns would, they shelter
/// each other until the mean drag of the trees on the ground that is theirs is rho u*^2. That is solved at
/// each wind, since crowns streamline. With the reach and the usual stand of `canopy` a place depends on the
/// trees within shelterReach() of it alone, to the bit. @param canopy where given, one stand for all.
std::shared_ptr<CanopyMap> canopyOf(const std::vector<CanopyTree>& trees, const WindCanopy& canopy = {});

/// One stand that goes on to all sides, of trees like these. @param height of it, metres.
/// @param frontalArea its index: m^2 over m^2 of ground.
std::shared_ptr<CanopyMap> canopyOf(const std::vector<CanopyTree>& trees, float height, float frontalArea);

/// Has parts of a forest take the stands of all of it. @param parts of it that stand for the whole: their
/// trees.
WindCanopy withUsualStands(WindCanopy canopy, const std::vector<std::vector<CanopyTree>>& parts);

/// How far trees matter to the wind at others, metres. @param canopy with a reach.
double shelterReach(const WindCanopy& canopy);

} // namespace osgTreeWind
