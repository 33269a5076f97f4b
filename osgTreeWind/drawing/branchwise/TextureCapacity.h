// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

struct ForestDescription;

/// @return why the textures cannot hold the trees of a forest under a branchwise law; empty if they can, and
/// under the law `modal`. @param description without problems in check().
std::string textureCapacityProblem(const ForestDescription& description);

} // namespace osgTreeWind
