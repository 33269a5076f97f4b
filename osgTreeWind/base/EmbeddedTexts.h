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

/// All that the library carries: the shaders and the catalogue of species. Generated at build time.
const std::vector<EmbeddedText>& embeddedTexts();

/// The embedded file of that name, or null if there is no such file.
inline const EmbeddedText* findEmbeddedText(const std::string& name) {
    for (const EmbeddedText& embedded : embeddedTexts())
        if (embedded.name == name)
            return &embedded;
    return nullptr;
}

} // namespace osgTreeWind
