// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <vector>

namespace osgTreeWind {

/// A mode of sway of a whole tree under the law `modal`.
struct SwayMode {
    double frequency = 0.0; ///< Hz, including the effect of weight.
    /// Damping ratio in calm air, released where the tip of trunk or branches that moves most is displaced by
    /// 1 % of the trunk's height; 1 (critical) for a mode that does not swing.
    double dampingRatio = 0.0;
    double share = 0.0; ///< Share of the energy of all modes under gusts, dropped modes included.
};

/// The modes of a tree, sorted by their energy under gusts. @param tree as for pullAndRelease().
std::vector<SwayMode> swayModes(const Species& species, const TreePlacement& tree);

} // namespace osgTreeWind
