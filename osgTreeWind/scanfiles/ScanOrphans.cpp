// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanOrphans.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace osgTreeWind {

namespace {

double cylinderVolume(const ScanCylinder& cylinder) {
    return glm::pi<double>() * cylinder.radius * cylinder.radius *
           glm::distance(cylinder.start, cylinder.end);
}

/// Distance from a point to the bark of a cylinder.
double barkDistance(const ScanCylinder& cylinder, const glm::dvec3& point) {
    const glm::dvec3 axis = cylinder.end - cylinder.start;
    const double along =
        glm::clamp(glm::dot(point - cylinder.start, axis) / std::max(glm::dot(axis, axis), 1e-12), 0.0, 1.0);
    return std::abs(glm::distance(point, cylinder.start + along * axis) - cylinder.radius);
}

/// The cylinder without a parent at the start of each cylinder's branch; -1 in a loop or with a missing
/// parent.
std::vector<int> findRoots(const ScanCylinders& cylinders) {
    constexpr int unknown = -2;
    const int count = static_cast<int>(cylinders.size());
    std::vector<int> roots(cylinders.size(), unknown), path;
    for (int i = 0; i < count; ++i) {
        int at = i;
        for (path.clear(); at >= 0 && at < count && roots[static_cast<std::size_t>(at)] == unknown;
             at = cylinders[static_cast<std::size_t>(at)].parent) {
            roots[static_cast<std::size_t>(at)] = -1; // it stays -1 in a loop
            path.push_back(at);
        }
        const int root = at >= 0 && at < count       ? roots[static_cast<std::size_t>(at)]
                         : at == -1 && !path.empty() ? path.back()
                                                     : -1;
        for (const int each : path)
            roots[static_cast<std::size_t>(each)] = root;
    }
    return roots;
}

} // namespace

Result<std::size_t> joinOrphans(ScanCylinders& cylinders) {
    if (std::count_if(cylinders.begin(), cylinders.end(),
                      [](const auto& each) { return each.parent == -1; }) < 2)
        return std::size_t(0);
    const std::vector<int> roots = findRoots(cylinders);
    std::vector<double> volumes(cylinders.size(), 0.0);
    double all = 0.0;
    for (std::size_t i = 0; i < cylinders.size(); ++i)
        if (roots[i] >= 0) {
            volumes[static_cast<std::size_t>(roots[i])] += cylinderVolume(cylinders[i]);
            all += cylinderVolume(cylinders[i]);
        }
    const auto trunk = std::max_element(volumes.begin(), volumes.end()) - volumes.begin();
    const auto root = static_cast<std::size_t>(trunk);
    constexpr double maxOrphanShare = 0.05;
    std::size_t joined = 0;
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
        if (cylinders[i].parent != -1 || i == root)
            continue;
        if (!(all - volumes[root] <= maxOrphanShare * all)) // also if a volume is NaN
            return fileProblem({},
                               "expected one root, found a second one besides line " +
                                   std::to_string(cylinders[root].line) +
                                   "; branches without a parent have " +
                                   numberText(std::round(1000.0 * (1.0 - volumes[root] / all)) / 10.0) +
                                   " % of the wood, and at most 5 % can be joined to the nearest cylinder",
                               cylinders[i].line);
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t other = 0; other < cylinders.size(); ++other)
            if (roots[other] == static_cast<int>(trunk))
                if (const double distance = barkDistance(cylinders[other], cylinders[i].start);
                    distance < nearest) {
                    nearest = distance;
                    cylinders[i].parent = static_cast<int>(other);
                }
        ++joined;
    }
    return joined;
}

} // namespace osgTreeWind
