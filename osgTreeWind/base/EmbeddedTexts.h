// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace osgTreeWind {

/// A file of the sources as it was when the library was built.
struct EmbeddedText {
    std::string name; ///< Relative to the top folder, e.g. "shaders/law/noise.glsl".
    std::string text;
};

/// All that the library carries: the shaders, and the catalogue of species. Generated at build time.
const std::vector<EmbeddedText>& embeddedTexts();

} // namespace osgTreeWind
