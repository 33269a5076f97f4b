// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanLinks.h>

#include <osgTreeWind/base/Problem.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr double joint = 0.001; // metres between a start and an end that are the same

/// A key of a cell of two joints' size.
std::uint64_t cellOf(const glm::dvec3& place) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
        key = (key ^ static_cast<std::uint64_t>(
                         static_cast<std::int64_t>(std::floor(place[axis] / (2.0 * joint))))) *
              0x9e3779b97f4a7c15u;
    return key;
}

/// The thickest cylinder that ends where each starts; -1 if there is none.
std::vector<int> cylindersBefore(const ScanCylinders& cylinders, glm::dvec3 ScanCylinder::*start,
                                 glm::dvec3 ScanCylinder::*end) {
    const auto at = [&](int index) -> const ScanCylinder& {
        return cylinders[static_cast<std::size_t>(index)];
    };
    std::unordered_map<std::uint64_t, int> thickest;
    for (int i = 0; i < static_cast<int>(cylinders.size()); ++i)
        if (int& there = thickest.emplace(cellOf(at(i).*end), i).first->second;
            at(i).radius > at(there).radius)
            there = i;
    std::vector<int> before(cylinders.size(), -1);
    for (std::size_t i = 0; i < cylinders.size(); ++i)
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 side(corner & 1 ? joint : -joint, corner & 2 ? joint : -joint,
                                  corner & 4 ? joint : -joint);
            const auto found = thickest.find(cellOf(cylinders[i].*start + side));
            if (found != thickest.end() && found->second != static_cast<int>(i) &&
                glm::distance(at(found->second).*end, cylinders[i].*start) <= joint)
                before[i] = found->second;
        }
    return before;
}

} // namespace

void joinEnds(ScanCylinders& cylinders) {
    std::vector<int> before = cylindersBefore(cylinders, &ScanCylinder::start, &ScanCylinder::end);
    const std::vector<int> after = cylindersBefore(cylinders, &ScanCylinder::end, &ScanCylinder::start);
    const bool isTurned =
        std::count(after.begin(), after.end(), -1) < std::count(before.begin(), before.end(), -1);
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
        cylinders[i].parent = (isTurned ? after : before)[i];
        if (isTurned)
            std::swap(cylinders[i].start, cylinders[i].end);
    }
}

void makeOneBased(std::vector<ScanLink>& links) {
    const bool isFromZero =
        std::any_of(links.begin(), links.end(), [](const ScanLink& link) { return link.parent == -1; });
    for (ScanLink& link : links)
        link.parent += isFromZero;
}

Result<std::vector<int>> resolveParents(const std::vector<ScanLink>& links, int root,
                                        const std::string& file) {
    std::unordered_map<int, int> indices;
    for (const ScanLink& link : links)
        if (!indices.emplace(link.id, static_cast<int>(indices.size())).second)
            return fileProblem(file, "expected unique ids, found " + std::to_string(link.id) + " again",
                               link.line);
    std::vector<int> parents;
    parents.reserve(links.size());
    for (const ScanLink& link : links) {
        const auto found = indices.find(link.parent);
        if (link.parent != root && found == indices.end())
            return fileProblem(
                file, "expected a parent of the same tree, found " + std::to_string(link.parent), link.line);
        parents.push_back(link.parent == root ? -1 : found->second);
    }
    return parents;
}

std::optional<Diagnostic> setParents(ScanCylinders& cylinders, const std::vector<ScanLink>& links, int root,
                                     const std::string& file) {
    const Result<std::vector<int>> parents = resolveParents(links, root, file);
    if (!parents)
        return parents.problems().front();
    for (std::size_t i = 0; i < cylinders.size(); ++i)
        cylinders[i].parent = parents.value()[i];
    return {};
}

Result<ScanCylinders> makeCylinders(const std::vector<ScanPoint>& points, int rootParent,
                                    const std::string& file) {
    std::vector<ScanLink> links;
    for (const ScanPoint& point : points)
        links.push_back(point.link);
    const Result<std::vector<int>> parents = resolveParents(links, rootParent, file);
    if (!parents)
        return parents.problems();
    std::vector<int> cylinderOf(points.size(), -1); // the cylinder that ends at the point
    for (std::size_t i = 0, count = 0; i < points.size(); ++i)
        if (parents.value()[i] >= 0)
            cylinderOf[i] = static_cast<int>(count++);
    ScanCylinders cylinders;
    std::vector<std::pair<std::size_t, int>> stems; // root points and the cylinders that start there
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (parents.value()[i] < 0)
            continue;
        const auto parent = static_cast<std::size_t>(parents.value()[i]);
        if (cylinderOf[parent] < 0)
            stems.emplace_back(parent, cylinderOf[i]);
        cylinders.push_back(
            {points[parent].place, points[i].place, points[i].radius, cylinderOf[parent], links[i].line});
    }
    const auto radiusOf = [&](int cylinder) { return cylinders[static_cast<std::size_t>(cylinder)].radius; };
    std::unordered_map<std::size_t, int> trunks; // the thickest stem of each root point
    for (const auto& [root, stem] : stems)
        if (int& trunk = trunks.emplace(root, stem).first->second; radiusOf(stem) > radiusOf(trunk))
            trunk = stem;
    for (const auto& [root, stem] : stems)
        if (stem != trunks[root])
            cylinders[static_cast<std::size_t>(stem)].parent = trunks[root];
    if (cylinders.empty())
        return fileProblem(file, "expected more than one point", links.empty() ? 0 : links.front().line);
    return cylinders;
}

} // namespace osgTreeWind
