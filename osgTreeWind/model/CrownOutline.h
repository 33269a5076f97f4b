// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/GrownTreeParameters.h>

namespace osgTreeWind {

/// Width of the crown over its largest one. @param r 0 at its top, 1 at its base.
float crownWidth(CrownOutline outline, float r);

} // namespace osgTreeWind
