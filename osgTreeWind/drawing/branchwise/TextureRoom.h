// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

struct ForestDescription;

/// Why the trees of a forest under a law of a branch have no room in textures; empty where they have, and
/// under `modal`. @param description for which check() finds nothing.
std::string problemOfTextures(const ForestDescription& description);

} // namespace osgTreeWind
