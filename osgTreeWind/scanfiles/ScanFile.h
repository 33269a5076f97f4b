// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>

#include <string>
#include <tuple>
#include <vector>

namespace osgTreeWind {

/// The most cylinders, and bytes, that a file of scanned trees may have.
constexpr std::size_t maxScanCylinders = 1000000, maxScanBytes = 400000000;

/// What a file of scanned trees holds.
struct ScanFile {
    std::string format; ///< "TreeQSM", "SimpleForest", "aRchi", "rTwig", "table", "RayCloudTools" or "SWC".
    std::vector<ScanCylinders> trees; ///< At least one; each is sound (problemOfScan).
    /// For each tree, how many branches without a parent were joined to the nearest wood.
    std::vector<std::size_t> joined{};

    auto parts() { return std::tie(format, trees); } ///< For Wire.
};

/// Reads trees that were fitted to laser scans, recognised by content: TreeQSM's cylinders as text (15 or 17
/// columns) or .mat (where the library was built with libmatio), tables of SimpleForest, aRchi or rTwig,
/// RayCloudTools' tree files (a line a tree), SWC. Metres in all of them.
/// A broken file gives one problem with its place, never a part of a tree.
Result<ScanFile> readScanFile(const std::string& path);

} // namespace osgTreeWind
