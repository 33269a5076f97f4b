// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <vector>

namespace osgTreeWind {

/// A way in which a whole tree sways under the law `modal`.
struct SwayMode {
    double frequency = 0.0; ///< With its weight, Hz.
    /// In a calm, let go where the tip that moves most, of the trunk or of a branch, is off by a hundredth of
    /// the trunk's height; 1 (critical) for a mode that does not swing.
    double dampingRatio = 0.0;
    double share = 0.0; ///< Of the energy of all modes under gusts, kept or not.
};

/// The modes in which a tree sways, those with most energy under gusts first.
/// @param tree as for pullAndRelease().
std::vector<SwayMode> swayModes(const Species& species, const TreePlacement& tree);

} // namespace osgTreeWind
