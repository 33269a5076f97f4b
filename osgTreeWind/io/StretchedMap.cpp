// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/StretchedMap.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/places/MapScale.h>

#include <cmath>

namespace osgTreeWind {

double mapMetresAt(const glm::dvec2& place, const Crs& map, const ForestReading& reading) {
    return reading.keepsStretchedMap ? 1.0 : scaleOfMap(map, place);
}

Result<Crs> sceneMapAt(const glm::dvec2& place, const Crs& map, ForestReading& reading) {
    const double scale = mapMetresAt(place, map, reading);
    if (scale == 1.0)
        return map;
    Result<Crs> zone = utmZoneOf(place, map, "crs");
    if (zone)
        reading.forest.notes.push_back(
            "a metre of " + map.name() + " is " + numberText(std::round(1000.0 / scale) / 1000.0) +
            " m on the ground here, so that the scene uses " + zone.value().name() +
            "; coordinates in the file still refer to the former (to use it for the scene, set stretched = "
            "true)");
    return zone;
}

void reprojectStretchedMap(ForestReading& reading) {
    if (!reading.crs || reading.forest.tiles)
        return;
    const TreeBounds trees = reading.treeBounds();
    if (trees.count == 0)
        return;
    const Result<Crs> map = sceneMapAt(0.5 * glm::dvec2(trees.low + trees.high), *reading.crs, reading);
    if (!map || map.value().isSame(*reading.crs))
        return;
    const Result<CrsTransform> transform = CrsTransform::between(*reading.crs, map.value());
    if (!transform)
        return;
    reading.toScene = transform.value();
    reading.setCrs(map.value());
    reading.trees.modify([&](TreeSpool::Trees& some, const std::vector<std::size_t>&) {
        std::vector<glm::dvec2> places;
        places.reserve(some.size());
        for (const TreePlacement& tree : some)
            places.emplace_back(tree.position);
        reading.toScene.apply(places);
        for (std::size_t i = 0; i < some.size(); ++i)
            some[i].position = {places[i], some[i].position.z};
    });
}

} // namespace osgTreeWind
