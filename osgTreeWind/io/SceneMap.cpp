// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/SceneMap.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/places/MapScale.h>

#include <cmath>

namespace osgTreeWind {

void SceneMap::read(TableReader& root) {
    root.read("stretched", _keepsStretched);
    if (_forest.crs.empty())
        return;
    auto crs = Crs::parseMap(_forest.crs);
    if (crs)
        _crs = std::move(crs.value());
    else
        root.problem("crs", crs.problems().front().message);
}

void SceneMap::set(const Crs& crs) {
    _crs = crs;
    _forest.crs = crs.text();
    _forest.crsFromInventory = true;
}

double SceneMap::metresAt(const glm::dvec2& place, const Crs& map) const {
    return _keepsStretched ? 1.0 : scaleOfMap(map, place);
}

Result<Crs> SceneMap::crsAt(const glm::dvec2& place, const Crs& map, TableReader& table) const {
    const double scale = metresAt(place, map);
    if (scale == 1.0)
        return map;
    Result<Crs> zone = utmZoneOf(place, map, "crs");
    if (zone)
        table.note("a metre of " + map.name() + " is " + numberText(std::round(1000.0 / scale) / 1000.0) +
                   " m on the ground here, so that the scene uses " + zone.value().name() +
                   "; coordinates in the file still refer to the former (to use it for the scene, set "
                   "stretched = true)");
    return zone;
}

void SceneMap::reproject(DocumentTrees& trees, TableReader& table) {
    if (!_crs || _forest.tiles)
        return;
    const TreeBounds& bounds = trees.bounds();
    if (bounds.count == 0)
        return;
    const Result<Crs> map = crsAt(0.5 * glm::dvec2(bounds.low + bounds.high), *_crs, table);
    if (!map || map.value().isSame(*_crs))
        return;
    const Result<CrsTransform> transform = CrsTransform::between(*_crs, map.value());
    if (!transform)
        return;
    _transform = transform.value();
    set(map.value());
    for (ExchangedPlace& each : trees.exchangedPlaces)
        for (glm::dvec2* place : {&each.place, &each.exchanged})
            _transform.apply(*place);
    trees.modify([&](TreeSpool::Trees& some, const std::vector<std::size_t>&) {
        std::vector<glm::dvec2> places;
        places.reserve(some.size());
        for (const TreePlacement& tree : some)
            places.emplace_back(tree.position);
        _transform.apply(places);
        for (std::size_t i = 0; i < some.size(); ++i)
            some[i].position = {places[i], some[i].position.z};
    });
}

glm::dvec3 SceneMap::toScene(const glm::dvec3& place) const {
    glm::dvec2 transformed(place);
    _transform.apply(transformed);
    return {transformed, place.z};
}

} // namespace osgTreeWind
