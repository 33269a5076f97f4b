// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/HostMap.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/CrsTransform.h>

#include <glm/geometric.hpp>

namespace osgTreeWind {
namespace {

Diagnostic withHostCrsKey(Diagnostic problem) {
    problem.key = "host_crs";
    return problem;
}

} // namespace

Result<glm::dmat4> hostMapTransform(const std::string& crs, const glm::dvec3& origin,
                                    const std::string& hostCrs) {
    if (crs.empty())
        return keyProblem("host_crs", "needs the crs of the forest");
    const Result<Crs> own = Crs::parseMap(crs), host = Crs::parseMap(hostCrs);
    if (!own)
        return own.problems();
    if (!host)
        return withHostCrsKey(host.problems().front());
    const Result<CrsTransform> toHost = CrsTransform::between(own.value(), host.value());
    if (!toHost)
        return withHostCrsKey(toHost.problems().front());
    constexpr double h = 100.0; // metres, step of the central differences
    const glm::dvec2 centre(origin);
    std::vector<glm::dvec2> points{centre, centre + glm::dvec2(h, 0.0), centre - glm::dvec2(h, 0.0),
                                   centre + glm::dvec2(0.0, h), centre - glm::dvec2(0.0, h)};
    toHost.value().apply(points);
    const glm::dvec2 x = (points[1] - points[2]) / (2.0 * h), y = (points[3] - points[4]) / (2.0 * h);
    const double scale = glm::length(x) + glm::length(y);
    if (!(scale > 0.0 && scale < 1e6) || !(glm::length(points[0]) < 1e9))
        return keyProblem("host_crs", "the origin of the forest lies outside this map");
    return glm::dmat4(glm::dvec4(x, 0.0, 0.0), glm::dvec4(y, 0.0, 0.0), glm::dvec4(0.0, 0.0, 1.0, 0.0),
                      glm::dvec4(points[0], origin.z, 1.0));
}

} // namespace osgTreeWind
