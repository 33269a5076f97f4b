// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/matlab/MatFile.h>

#include <osgTreeWind/scanfiles/ScanFile.h>

namespace osgTreeWind {

/// The trees of TreeQSM: structs with the arrays radius, length, start, axis and parent, be they variables,
/// their field `cylinder`, or so in arrays and cells; of version 2.0, the variables Rad, Len, Sta, Axe, CPar.
/// The line of a cylinder is its number.
/// @param path for diagnostics only.
Result<ScanFile> readTreeQsmMat(const MatFile& file, const std::string& path);

} // namespace osgTreeWind
