// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>

#include <optional>
#include <string>
#include <vector>

/// How the readers of scans find parents. Not part of the interface.
namespace osgTreeWind {

/// What a file calls a piece and the piece it springs from.
struct ScanName {
    int id = 0;
    int parent = 0;
    int line = 0; ///< 1-based.
};

/// Where parents count from 0, with -1 for that of the root, as PyTLidar writes them, makes them count
/// from 1.
void countFromOne(std::vector<ScanName>& names);

/// Index of the parent of each; -1 for those with `root` as parent. Problems: an id twice, no such parent.
Result<std::vector<int>> parentsOf(const std::vector<ScanName>& names, int root, const std::string& file);
/// Gives those parents to cylinders of these names. @return the problem, if there is one.
std::optional<Diagnostic> linkCylinders(ScanCylinders& cylinders, const std::vector<ScanName>& names,
                                        int root, const std::string& file);

/// A point of a tree that a file has as points.
struct ScanPoint {
    glm::dvec3 place{0.0};
    double radius = 0.0;
    ScanName name; ///< The root's parent is -1.
};

/// A cylinder from each point's parent to itself, of its radius. Where several spring from the root, the
/// thickest is the first of the trunk and bears the others. Branches from a second root have no parent.
/// Besides those of parentsOf(), a root on its own is a problem.
Result<ScanCylinders> cylindersOf(const std::vector<ScanPoint>& points, const std::string& file);

} // namespace osgTreeWind
