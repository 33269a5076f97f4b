// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace osgTreeWind {

/// What is wrong with the header of a classic NetCDF file (CDF-1, 2 or 5): a list that claims more than the
/// file holds, for which libnetcdf would ask gigabytes of memory. Empty when all is well, and for other
/// files. Not part of the interface.
std::string problemOfNetCdfHeader(std::string_view bytes);

} // namespace osgTreeWind
