// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/CheckScan.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Range.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {
namespace {

constexpr double shortestCylinder = 1e-6, thickestCylinder = 10.0; // metres
constexpr double lowestScan = 0.1, highestScan = 150.0, widestScan = 200.0;

Diagnostic problem(const ScanCylinder& cylinder, std::string message) {
    return fileProblem({}, std::move(message), cylinder.line);
}

std::string problemOfForm(const ScanCylinder& cylinder) {
    if (!(cylinder.radius > 0.0 && cylinder.radius <= thickestCylinder))
        return "expected a radius above 0 and of at most 10 m, found " + numberText(cylinder.radius);
    if (!(glm::distance(cylinder.start, cylinder.end) >= shortestCylinder)) // also true for NaN
        return "expected a cylinder of at least a micrometre";
    return {};
}

/// Marks cylinders that are not connected to the root.
std::vector<bool> findUnreachable(const ScanCylinders& cylinders, std::size_t root) {
    std::vector<std::vector<std::size_t>> children(cylinders.size());
    for (std::size_t i = 0; i < cylinders.size(); ++i)
        if (i != root)
            children[static_cast<std::size_t>(cylinders[i].parent)].push_back(i);
    std::vector<bool> lost(cylinders.size(), true);
    for (std::vector<std::size_t> open = {root}; !open.empty();) {
        const std::size_t next = open.back();
        open.pop_back();
        lost[next] = false;
        open.insert(open.end(), children[next].begin(), children[next].end());
    }
    return lost;
}

/// The cylinder of lowest index on a loop, if there is one.
std::optional<std::size_t> findLoop(const ScanCylinders& cylinders, std::size_t root) {
    const std::vector<bool> lost = findUnreachable(cylinders, root);
    const auto found = std::find(lost.begin(), lost.end(), true);
    if (found == lost.end())
        return std::nullopt;
    auto at = static_cast<std::size_t>(found - lost.begin());
    for (std::size_t step = 0; step < cylinders.size(); ++step) // enough steps to be on the loop
        at = static_cast<std::size_t>(cylinders[at].parent);
    std::size_t first = at;
    for (auto next = static_cast<std::size_t>(cylinders[at].parent); next != at;
         next = static_cast<std::size_t>(cylinders[next].parent))
        first = std::min(first, next);
    return first;
}

std::optional<Diagnostic> problemOfSize(const ScanCylinders& cylinders, const ScanCylinder& root) {
    glm::dvec3 low = root.start, high = low;
    for (const ScanCylinder& cylinder : cylinders) {
        low = glm::min(low, glm::min(cylinder.start, cylinder.end));
        high = glm::max(high, glm::max(cylinder.start, cylinder.end));
    }
    const glm::dvec3 size = high - low;
    const double height = high.z - root.start.z;
    if (!(height >= lowestScan && height <= highestScan))
        return problem(root, "expected a tree of 0.1 to 150 m above its foot, in metres, found " +
                                 numberText(height));
    if (std::max({size.x, size.y, size.z}) > widestScan)
        return problem(root, "expected a tree of at most 200 m across, in metres, found " +
                                 numberText(std::max({size.x, size.y, size.z})));
    return std::nullopt;
}

} // namespace

std::optional<Diagnostic> problemOfScan(const ScanCylinders& cylinders) {
    if (cylinders.empty())
        return fileProblem({}, "expected at least one cylinder");
    const ScanCylinder* root = nullptr;
    for (const ScanCylinder& cylinder : cylinders) {
        if (const std::string wrong = problemOfForm(cylinder); !wrong.empty())
            return problem(cylinder, wrong);
        if (cylinder.parent < -1 || cylinder.parent >= static_cast<int>(cylinders.size()))
            return problem(cylinder, "expected a parent among the cylinders");
        if (cylinder.parent >= 0)
            continue;
        if (root)
            return problem(cylinder, "expected one root, found a second one besides line " +
                                         std::to_string(root->line));
        root = &cylinder;
    }
    if (!root)
        return fileProblem({}, "expected a root: a cylinder without a parent");
    if (const auto looped = findLoop(cylinders, static_cast<std::size_t>(root - cylinders.data())))
        return problem(cylinders[*looped], "expected parents that lead to the root, found a loop");
    return problemOfSize(cylinders, *root);
}

namespace {

bool isWithin(const glm::vec3& point, double most) {
    return within(-most, most).contains(static_cast<double>(point.x)) &&
           within(-most, most).contains(static_cast<double>(point.y)) &&
           within(-most, most).contains(static_cast<double>(point.z));
}

std::string problemOfUnit(const BranchUnit& unit, int index) {
    if (unit.parent < (index == 0 ? -1 : 0) || unit.parent >= index)
        return "expected a parent before it, found " + std::to_string(unit.parent);
    if (!within(0, index).contains(unit.level))
        return "expected a level from 0 on, found " + std::to_string(unit.level);
    if (!isWithin(unit.base, widestScan) || !isWithin(unit.tip, widestScan))
        return "expected its ends within 200 m";
    if (!above(0, thickestCylinder).contains(static_cast<double>(unit.baseRadius)) ||
        !within(0, thickestCylinder).contains(static_cast<double>(unit.tipRadius)))
        return "expected radii above 0 and of at most 10 m";
    return above(0, 1).contains(static_cast<double>(unit.attach)) ? "" : "expected attach in (0, 1]";
}

std::string problemOfShoot(const Skeleton& skeleton, const Shoot& shoot, int leastUnit) {
    if (shoot.unit < leastUnit || shoot.unit >= static_cast<int>(skeleton.units.size()))
        return "expected a unit, in the order of units, found " + std::to_string(shoot.unit);
    const std::size_t points = skeleton.shootPoints.size();
    if (shoot.count < 2 || shoot.first > points || shoot.count > points - shoot.first)
        return "expected 2 or more points among those of shoots, found " + std::to_string(shoot.count);
    if (!above(0, thickestCylinder).contains(static_cast<double>(shoot.baseRadius)) ||
        !within(0, thickestCylinder).contains(static_cast<double>(shoot.tipRadius)))
        return "expected radii above 0 and of at most 10 m";
    return "";
}

std::string problemOfShoots(const Skeleton& skeleton) {
    if (skeleton.shoots.size() > maxScanShoots)
        return "expected at most " + std::to_string(maxScanShoots) + " shoots, found " +
               std::to_string(skeleton.shoots.size());
    if (!skeleton.leafyUnits.empty() && skeleton.leafyUnits.size() != skeleton.units.size())
        return "expected a leafy part for each unit or for none, found " +
               std::to_string(skeleton.leafyUnits.size());
    int unit = 0;
    for (std::size_t i = 0; i < skeleton.shoots.size(); ++i) {
        if (const std::string problem = problemOfShoot(skeleton, skeleton.shoots[i], unit); !problem.empty())
            return "shoot " + std::to_string(i) + ": " + problem;
        unit = skeleton.shoots[i].unit;
    }
    for (const glm::vec3& point : skeleton.shootPoints)
        if (!isWithin(point, widestScan))
            return "expected points of shoots within 200 m";
    return "";
}

} // namespace

std::string problemOfSkeleton(const Skeleton& skeleton) {
    if (!within(2, 64).contains(skeleton.ringsPerBranch))
        return "expected 2 to 64 rings a branch, found " + std::to_string(skeleton.ringsPerBranch);
    if (!within(0, 3).contains(static_cast<double>(skeleton.flare)))
        return "expected a flare in [0, 3], found " + numberText(static_cast<double>(skeleton.flare));
    if (skeleton.units.empty() || skeleton.units.size() > maxScanUnits)
        return "expected 1 to " + std::to_string(maxScanUnits) + " units, found " +
               std::to_string(skeleton.units.size());
    if (skeleton.points.size() != skeleton.units.size() * static_cast<std::size_t>(skeleton.ringsPerBranch))
        return "expected a point for each ring of each unit, found " + std::to_string(skeleton.points.size());
    for (std::size_t i = 0; i < skeleton.units.size(); ++i)
        if (const std::string problem = problemOfUnit(skeleton.units[i], static_cast<int>(i));
            !problem.empty())
            return "unit " + std::to_string(i) + ": " + problem;
    for (const glm::vec3& point : skeleton.points)
        if (!isWithin(point, widestScan))
            return "expected points within 200 m";
    if (const std::string problem = problemOfShoots(skeleton); !problem.empty())
        return problem;
    const double height = static_cast<double>(skeleton.height());
    return within(0.5 * lowestScan, highestScan).contains(height)
               ? ""
               : "expected a height of 0.05 to 150 m, found " + numberText(height);
}

} // namespace osgTreeWind
