// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/base/UnitsOfMeasure.h>

namespace osgTreeWind {

/// Size of a unit as by knownUnit(), or else by UDUNITS, which osgtreewind-map links: "m.s-1", "mi/h" or
/// "0.5 m". UDUNITS is asked for lengths and speeds only. Errors list the units of .treewind files and have
/// no file.
Result<double> sizeOfUnit(Dimension dimension, const std::string& name);

} // namespace osgTreeWind
