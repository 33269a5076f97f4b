// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/PalmParameters.h>
#include <osgTreeWind/model/Skeleton.h>

namespace osgTreeWind {

/// The parameters with every value brought into its range; NaN becomes the default.
PalmParameters clamped(PalmParameters parameters);

/// Makes the skeleton of a palm: a stem of five units (level 0) and its fronds (level 1), which follow each
/// other up the stem by the golden angle and reach to the width and height of the crown. Parameters out of
/// their ranges are clamped().
Skeleton makePalmTree(const PalmParameters& parameters);

} // namespace osgTreeWind
