// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

// Generated at build time, for keys of the user's cache.

/// Hash of the sources that determine how trees grow: those of the folders growth and base.
const char* growthSourceHash();
/// Hash of the compiler and of the sources that determine how pictures and textures of trees are painted.
const char* paintSourceHash();

} // namespace osgTreeWind
