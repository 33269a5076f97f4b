// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/ReaderProcess.h>
#include <osgTreeWind/windfiles/WindFormats.h>

namespace osgTreeWind {

namespace {

Result<WindContent> readWeather(const char* format, const char* libraries, const std::string& path,
                                const WindRequest& request) {
    const WindArea area = request.area.value_or(WindArea{"all"});
    std::vector<std::string> command = {path,
                                        request.secondFile,
                                        request.asStored ? "stored" : "grid",
                                        area.crs,
                                        numberText(area.low.x),
                                        numberText(area.low.y),
                                        numberText(area.high.x),
                                        numberText(area.high.y)};
    command.insert(command.end(), request.variable.begin(), request.variable.end());
    if (!request.secondFile.empty())
        if (const auto problem = problemOfInput(request.secondFile))
            return *problem;
    return readWithProgram<WindContent>({"osgtreewind-weather", "OSGTREEWIND_WEATHER", format, libraries},
                                        command);
}

} // namespace

Result<WindContent> readNetCdf(const std::string& path, const WindRequest& request) {
    return readWeather("NetCDF", "GDAL", path, request);
}

Result<WindContent> readGrib(const std::string& path, const WindRequest& request) {
    return readWeather("GRIB", "GDAL and ecCodes", path, request);
}

} // namespace osgTreeWind
