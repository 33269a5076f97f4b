// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

struct ForestDescription;

/// How long a frame of a forest lasts, seconds: as the environment variable OSGTREEWIND_STEP says, else the
/// description; 0: as its stamp says. What else the variable says is warned of once in a process.
double frameStepOf(const ForestDescription& description);

} // namespace osgTreeWind
