// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/HostMap.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/CrsWay.h>

#include <glm/geometric.hpp>

namespace osgTreeWind {
namespace {

Diagnostic problemOf(Diagnostic problem) {
    problem.key = "host_crs";
    return problem;
}

} // namespace

Result<glm::dmat4> placeOnHostMap(const ForestDescription& forest) {
    if (forest.crs.empty())
        return keyProblem("host_crs", "expected the forest's own crs beside it");
    const Result<Crs> own = Crs::parseMap(forest.crs), host = Crs::parseMap(forest.hostCrs);
    if (!own)
        return own.problems();
    if (!host)
        return problemOf(host.problems().front());
    const Result<CrsWay> way = CrsWay::between(own.value(), host.value());
    if (!way)
        return problemOf(way.problems().front());
    constexpr double reach = 100.0; // metres to each side of the origin
    const glm::dvec2 origin(forest.origin);
    std::vector<glm::dvec2> places{origin, origin + glm::dvec2(reach, 0.0), origin - glm::dvec2(reach, 0.0),
                                   origin + glm::dvec2(0.0, reach), origin - glm::dvec2(0.0, reach)};
    way.value().go(places);
    const glm::dvec2 x = (places[1] - places[2]) / (2.0 * reach), y = (places[3] - places[4]) / (2.0 * reach);
    const double size = glm::length(x) + glm::length(y);
    if (!(size > 0.0 && size < 1e6) || !(glm::length(places[0]) < 1e9))
        return keyProblem("host_crs", "the origin of the forest has no place on this map");
    return glm::dmat4(glm::dvec4(x, 0.0, 0.0), glm::dvec4(y, 0.0, 0.0), glm::dvec4(0.0, 0.0, 1.0, 0.0),
                      glm::dvec4(places[0], forest.origin.z, 1.0));
}

} // namespace osgTreeWind
