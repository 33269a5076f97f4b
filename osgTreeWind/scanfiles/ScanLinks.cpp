// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanLinks.h>

#include <osgTreeWind/base/Problem.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace osgTreeWind {

void countFromOne(std::vector<ScanName>& names) {
    const bool isFromZero =
        std::any_of(names.begin(), names.end(), [](const ScanName& name) { return name.parent == -1; });
    for (ScanName& name : names)
        name.parent += isFromZero;
}

Result<std::vector<int>> parentsOf(const std::vector<ScanName>& names, int root, const std::string& file) {
    std::unordered_map<int, int> indices;
    for (const ScanName& name : names)
        if (!indices.emplace(name.id, static_cast<int>(indices.size())).second)
            return fileProblem(file, "expected each id once, found " + std::to_string(name.id) + " again",
                               name.line);
    std::vector<int> parents;
    parents.reserve(names.size());
    for (const ScanName& name : names) {
        const auto found = indices.find(name.parent);
        if (name.parent != root && found == indices.end())
            return fileProblem(
                file, "expected a parent of the same tree, found " + std::to_string(name.parent), name.line);
        parents.push_back(name.parent == root ? -1 : found->second);
    }
    return parents;
}

std::optional<Diagnostic> linkCylinders(ScanCylinders& cylinders, const std::vector<ScanName>& names,
                                        int root, const std::string& file) {
    const Result<std::vector<int>> parents = parentsOf(names, root, file);
    if (!parents)
        return parents.problems().front();
    for (std::size_t i = 0; i < cylinders.size(); ++i)
        cylinders[i].parent = parents.value()[i];
    return {};
}

Result<ScanCylinders> cylindersOf(const std::vector<ScanPoint>& points, const std::string& file) {
    std::vector<ScanName> names;
    for (const ScanPoint& point : points)
        names.push_back(point.name);
    const Result<std::vector<int>> parents = parentsOf(names, -1, file);
    if (!parents)
        return parents.problems();
    std::vector<int> cylinderOf(points.size(), -1); // that ends in the point
    for (std::size_t i = 0, count = 0; i < points.size(); ++i)
        if (parents.value()[i] >= 0)
            cylinderOf[i] = static_cast<int>(count++);
    ScanCylinders cylinders;
    std::vector<std::pair<std::size_t, int>> stems; // root points, and the cylinders that spring from them
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (parents.value()[i] < 0)
            continue;
        const auto parent = static_cast<std::size_t>(parents.value()[i]);
        if (cylinderOf[parent] < 0)
            stems.emplace_back(parent, cylinderOf[i]);
        cylinders.push_back(
            {points[parent].place, points[i].place, points[i].radius, cylinderOf[parent], names[i].line});
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
        return fileProblem(file, "expected more than one point", names.empty() ? 0 : names.front().line);
    return cylinders;
}

} // namespace osgTreeWind
