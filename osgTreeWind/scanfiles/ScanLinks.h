// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>

#include <optional>
#include <string>
#include <vector>

/// Parents of the cylinders of scans. Not part of the interface.
namespace osgTreeWind {

/// Id of a cylinder or point in a file, and the id of its parent.
struct ScanLink {
    int id = 0;
    int parent = 0;
    int line = 0; ///< 1-based.
};

/// Makes parent numbers one-based, with 0 for the root, if they are zero-based, with -1 for the root (as
/// written by PyTLidar).
void makeOneBased(std::vector<ScanLink>& links);

/// Indices of the parents; -1 where the parent is `root`. Fails if an id is not unique or a parent is
/// missing.
Result<std::vector<int>> resolveParents(const std::vector<ScanLink>& links, int root,
                                        const std::string& file);
/// Sets the parents of the cylinders with these links. @return the error of resolveParents(), if any.
std::optional<Diagnostic> setParents(ScanCylinders& cylinders, const std::vector<ScanLink>& links, int root,
                                     const std::string& file);

/// A point of a tree that a file describes by points.
struct ScanPoint {
    glm::dvec3 place{0.0};
    double radius = 0.0;
    ScanLink link;
};

/// Makes a cylinder from each point's parent to the point, with the radius of the point. If several start at
/// the root, the thickest becomes the trunk and the parent of the others. Branches from a second root have no
/// parent. Fails like resolveParents(), and if there is no cylinder.
/// @param rootParent the parent of roots.
Result<ScanCylinders> makeCylinders(const std::vector<ScanPoint>& points, int rootParent,
                                    const std::string& file);

/// Sets the parents of cylinders without any: of each the cylinder that ends where it starts, within a
/// millimetre. All are turned round if more of them would be joined then.
void joinEnds(ScanCylinders& cylinders);

} // namespace osgTreeWind
