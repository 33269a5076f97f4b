// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/scanfiles/ScanFile.h>

#include <optional>
#include <string_view>

/// The readers behind readScanFile(), one for each format, over a text in memory. Not part of the interface.
/// The cylinders they give have parents that are there; problemOfScan() says the rest.
namespace osgTreeWind {

/// The text in whichever of the formats it is, its trees sound.
Result<ScanFile> readScan(std::string_view text, const std::string& file);

/// Joins the orphans of all trees (ScanOrphans) and counts them. @return why a tree is not sound then, with
/// its number as key where there are several.
std::optional<Diagnostic> settleTrees(ScanFile& scan);

/// radius, length, start x y z, axis x y z, parent (counts from 1; 0: the root), and 6 or 8 columns more; by
/// blanks or commas, with a line of names above them or without.
Result<ScanFile> readTreeQsm(std::string_view text, const std::string& file);
/// A table of SimpleForest, aRchi or rTwig: columns by name (ScanColumns), parted by commas, semicolons, tabs
/// or blanks. The root's parent is -1, 0 where that is no cylinder's id, NA or nothing.
Result<ScanFile> readScanTable(std::string_view text, const std::string& file);
/// A line of names, x,y,z,radius,parent_id among them, then one line a tree: the values of all its segments,
/// one after the other. A segment is the cylinder from its parent's x, y, z to its own; the first is a point.
Result<ScanFile> readRayCloudTree(std::string_view text, const std::string& file);
/// id, type, x, y, z, radius, parent (-1: the root): points. A cylinder leads from the parent to a point, and
/// has the radius of that point.
Result<ScanFile> readSwc(std::string_view text, const std::string& file);

/// Whether a file that begins like this is MATLAB's .mat, of version 5 to 7 or 7.3.
bool isMatlab(std::string_view head);
/// A .mat with TreeQSM's structs, its trees sound. It is read by the program osgtreewind-matlab in a process
/// of its own: a damaged file ends that one only.
Result<ScanFile> readMatlab(const std::string& path);

} // namespace osgTreeWind
