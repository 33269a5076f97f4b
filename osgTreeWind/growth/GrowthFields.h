// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Field.h>
#include <osgTreeWind/growth/GrowthParameters.h>

namespace osgTreeWind {

/// Fields of the size, the habit, the flare and the seed. The site has none: it follows from the tree's
/// place.
template <>
const Fields& fieldsOf<GrowthParameters>();

} // namespace osgTreeWind
