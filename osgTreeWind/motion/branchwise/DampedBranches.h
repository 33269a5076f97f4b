// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/species/Species.h>

#include <vector>

namespace osgTreeWind {

// Not for installed headers, as Laws.h.

/// What every unit of a tree is to the law `damped`. Each unit moves all that it carries, at its true
/// distance: the static deflection is that of the bent wood under the drag of all parts, and the frequency
/// that of the first mode of its axis with everything upon it (docs/validation.md has the derivation).
/// @param leaves share of its leaves that the tree bears, [0, 1].
std::vector<Laws::DampedBranch> makeDampedBranches(const TreeModel& model, const TreeScale& scale,
                                                   const Species& species, float leaves = 1.0f);

/// The same with an answer `gain` times as large: same frequency, same damping, more torque.
Laws::DampedBranch exaggerated(Laws::DampedBranch branch, float gain);

} // namespace osgTreeWind
