// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/ReaderProgram.h>
#include <osgTreeWind/windfiles/WindFormats.h>
#include <osgTreeWind/windfiles/WindWire.h>

namespace osgTreeWind {

Result<WindContent> readNetCdf(const std::string& path, bool asStored) {
    constexpr ReaderProgram reader{"osgtreewind-netcdf", "OSGTREEWIND_NETCDF", "NetCDF", "GDAL"};
    std::optional<Result<WindContent>> content;
    const auto problem = runReader(reader, path, asStored ? "stored" : "grid", [&](int answer) {
        content = WindWire::receive(answer);
        return content.has_value();
    });
    return problem ? Result<WindContent>(*problem) : std::move(*content);
}

} // namespace osgTreeWind
