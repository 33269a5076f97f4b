// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/scanfiles/ScanFile.h>

#include <optional>
#include <string_view>

/// Readers of single formats for readScanFile(), from text in memory. Not part of the interface. All parents
/// of their cylinders exist; joinAndCheckTrees() checks the rest.
namespace osgTreeWind {

/// Reads text of any of the formats, and checks the trees.
Result<ScanFile> readScan(std::string_view text, const std::string& file, ScanUp up = ScanUp::Found);

/// Joins and counts the orphans of all trees (joinOrphans()), turns z up, and checks the trees. @return the
/// first error, with the tree's number as key if there are several trees.
std::optional<Diagnostic> joinAndCheckTrees(ScanFile& scan, ScanUp up);

/// Columns: radius, length, start x y z, axis x y z, parent (one-based; 0 for the root), and 6 or 8 more,
/// separated by blanks or commas, with or without a header.
Result<ScanFile> readTreeQsm(std::string_view text, const std::string& file);
/// A table of cylinders, as of SimpleForest, aRchi or rTwig, or of points: columns by name (ScanColumns),
/// separated by commas, semicolons, tabs or blanks. The root's parent is -1, NA, empty, itself, or 0 if no
/// cylinder has that id. Cylinders without a column of parents are joined end to start.
Result<ScanFile> readScanTable(std::string_view text, const std::string& file);
/// A header with x,y,z,radius,parent_id, then one line per tree with the values of all its segments. A
/// segment is the cylinder from its parent's x, y, z to its own; the first segment is a point.
Result<ScanFile> readRayCloudTree(std::string_view text, const std::string& file);
/// Points: id, type, x, y, z, radius, parent (-1 for the root). A cylinder leads from the parent to the point
/// and has the radius of the point.
Result<ScanFile> readSwc(std::string_view text, const std::string& file);

/// Whether the first bytes of a file are those of MATLAB's .mat, version 5 to 7 or 7.3.
bool isMatlab(std::string_view head);
/// Reads TreeQSM's structs from a .mat file, and checks the trees. The program osgtreewind-matlab reads the
/// file in a separate process, which a damaged file may crash.
Result<ScanFile> readMatlab(const std::string& path, ScanUp up);

} // namespace osgTreeWind
