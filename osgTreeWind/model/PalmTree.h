// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/PalmParameters.h>
#include <osgTreeWind/model/Skeleton.h>

namespace osgTreeWind {

/// Clamps every value to its range; NaN becomes the default.
PalmParameters clamped(PalmParameters parameters);

/// Makes the skeleton of a palm: a stem of five units (level 0) and its fronds (level 1), which follow each
/// other up the stem by the golden angle and fill the crown. Parameters are clamped().
Skeleton makePalmTree(const PalmParameters& parameters);

} // namespace osgTreeWind
