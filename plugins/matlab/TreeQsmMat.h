// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/matlab/MatFile.h>

#include <osgTreeWind/scanfiles/ScanFile.h>

namespace osgTreeWind {

/// Reads the trees of TreeQSM: structs with the arrays radius, length, start, axis and parent, in variables,
/// in their field `cylinder`, and in arrays and cells of these; for version 2.0 the variables Rad, Len, Sta,
/// Axe and CPar. The line of a cylinder is its number.
/// @param path for diagnostics only.
Result<ScanFile> readTreeQsmMat(const MatFile& file, const std::string& path);

} // namespace osgTreeWind
