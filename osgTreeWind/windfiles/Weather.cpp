// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/ReaderProgram.h>
#include <osgTreeWind/windfiles/WindFormats.h>
#include <osgTreeWind/windfiles/WindWire.h>

namespace osgTreeWind {

namespace {

Result<WindContent> readWeather(const char* format, const char* libraries, const std::string& path,
                                const WindRequest& request) {
    const ReaderProgram reader{"osgtreewind-weather", "OSGTREEWIND_WEATHER", format, libraries};
    std::vector<std::string> wanted = {request.asStored ? "stored" : "grid"};
    if (const auto& area = request.area)
        wanted.insert(wanted.end(), {area->crs, numberText(area->low.x), numberText(area->low.y),
                                     numberText(area->high.x), numberText(area->high.y)});
    std::optional<Result<WindContent>> content;
    const auto problem = runReader(reader, path, wanted, [&](int answer) {
        content = Wire::receive<WindContent>(answer);
        return content.has_value();
    });
    return problem ? Result<WindContent>(*problem) : std::move(*content);
}

} // namespace

Result<WindContent> readNetCdf(const std::string& path, const WindRequest& request) {
    return readWeather("NetCDF", "GDAL", path, request);
}

Result<WindContent> readGrib(const std::string& path, const WindRequest& request) {
    return readWeather("GRIB", "GDAL and ecCodes", path, request);
}

} // namespace osgTreeWind
