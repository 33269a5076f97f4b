// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace osgTreeWind {

/// A file of the folder shaders/ as it was when the library was built.
struct EmbeddedShader {
    const char* name; ///< Relative to shaders/, e.g. "law/noise.glsl".
    const char* text;
};

/// All of them, in the order of shaders/CMakeLists.txt. Generated at build time.
const std::vector<EmbeddedShader>& embeddedShaders();

} // namespace osgTreeWind
