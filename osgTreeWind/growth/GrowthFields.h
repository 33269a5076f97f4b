// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Field.h>
#include <osgTreeWind/growth/GrowthParameters.h>

namespace osgTreeWind {

/// The size, the numbers of the habit, and the seed; the site follows from where a tree stands.
template <>
const Fields& fieldsOf<GrowthParameters>();

} // namespace osgTreeWind
