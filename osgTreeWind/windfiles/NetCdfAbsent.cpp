// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFormats.h>

namespace osgTreeWind {

Result<WindContent> readNetCdf(const std::string& path, bool) {
    return Diagnostic{path, 0, 0, {}, "NetCDF needs GDAL; build osgTreeWind with -DOSGTREEWIND_GDAL=ON"};
}

} // namespace osgTreeWind
