// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>

#include <string>
#include <tuple>
#include <vector>

namespace osgTreeWind {

/// Largest number of cylinders and of bytes in a file of scanned trees.
constexpr std::size_t maxScanCylinders = 1000000, maxScanBytes = 400000000;

/// Content of a file of scanned trees.
struct ScanFile {
    std::string format; ///< "TreeQSM", "SimpleForest", "aRchi", "rTwig", "table", "table of points",
                        ///< "RayCloudTools" or "SWC".
    std::vector<ScanCylinders> trees; ///< At least one; each is sound (problemOfScan).
    bool hasParents = true;           ///< Whether the file says which cylinder springs from which.
    /// For each tree, the number of branches without a parent that were joined to the nearest cylinder.
    std::vector<std::size_t> joined{};
    std::vector<std::string> notes{}; ///< Assumptions, one sentence each.

    auto parts() { return std::tie(format, trees); } ///< For Wire.
};

/// The axis that points up in a file of scanned trees. Found: y if the trees lie along it, otherwise z.
enum class ScanUp { Found, Y, Z };

/// Reads cylinder models of laser scans. The format is recognised by content: TreeQSM's cylinders as text (15
/// or 17 columns) or .mat (if the library was built with libmatio), tables of cylinders or points with named
/// columns, RayCloudTools' tree files (one line per tree), or SWC. All are in metres.
/// A damaged file gives one error with its place, never part of a tree.
Result<ScanFile> readScanFile(const std::string& path, ScanUp up = ScanUp::Found);

} // namespace osgTreeWind
