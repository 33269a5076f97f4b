// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanLinks.h>

#include <osgTreeWind/base/Problem.h>

#include <unordered_map>

namespace osgTreeWind {

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
    int root = -1;
    std::vector<int> cylinderOf(points.size(), -1); // that ends in the point
    for (std::size_t i = 0, count = 0; i < points.size(); ++i) {
        if (parents.value()[i] >= 0) {
            cylinderOf[i] = static_cast<int>(count++);
            continue;
        }
        if (root >= 0)
            return fileProblem(file, "expected one root, found another", names[i].line);
        root = static_cast<int>(i);
    }
    ScanCylinders cylinders;
    int trunk = -1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const int parent = parents.value()[i];
        if (parent < 0)
            continue;
        ScanCylinder cylinder;
        cylinder.start = points[static_cast<std::size_t>(parent)].place;
        cylinder.end = points[i].place;
        cylinder.radius = points[i].radius;
        cylinder.parent = cylinderOf[static_cast<std::size_t>(parent)];
        cylinder.line = names[i].line;
        if (cylinder.parent < 0 &&
            (trunk < 0 || cylinder.radius > cylinders[static_cast<std::size_t>(trunk)].radius))
            trunk = cylinderOf[i];
        cylinders.push_back(cylinder);
    }
    for (int i = 0; i < static_cast<int>(cylinders.size()); ++i) {
        int& parent = cylinders[static_cast<std::size_t>(i)].parent;
        if (parent < 0 && i != trunk)
            parent = trunk;
    }
    if (cylinders.empty())
        return fileProblem(file, "expected more than one point", names.empty() ? 0 : names.front().line);
    return cylinders;
}

} // namespace osgTreeWind
