// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/Crs.h>

#include <osgTreeWind/base/Problem.h>

#include <cmath>

namespace osgTreeWind {

Result<Crs> Crs::parseMap(const std::string& text) {
    Result<Crs> crs = parse(text);
    if (crs && !crs.value().problemOfMap().empty())
        return keyProblem("crs", crs.value().problemOfMap());
    return crs;
}

Result<Crs> Crs::utmOf(const glm::dvec2& longitudeLatitude) {
    const double turns = std::floor((longitudeLatitude.x + 180.0) / 6.0);
    const int zone = 1 + static_cast<int>(turns - 60.0 * std::floor(turns / 60.0));
    return parse("EPSG:" + std::to_string((longitudeLatitude.y < 0.0 ? 32700 : 32600) + zone));
}

Crs Crs::wgs84() {
    return Crs({"EPSG:4326", "WGS 84",
                "expected a projected system in metres, found WGS 84, which uses degrees", true});
}

} // namespace osgTreeWind
