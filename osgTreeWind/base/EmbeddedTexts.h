// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace osgTreeWind {

/// A source file that was compiled into the library.
struct EmbeddedText {
    std::string name; ///< Relative to the repository, e.g. "shaders/law/noise.glsl".
    std::string text;
};

/// All embedded files: the shaders and the species catalogue. Generated at build time.
const std::vector<EmbeddedText>& embeddedTexts();

/// The embedded file with that name, or null.
inline const EmbeddedText* findEmbeddedText(const std::string& name) {
    for (const EmbeddedText& embedded : embeddedTexts())
        if (embedded.name == name)
            return &embedded;
    return nullptr;
}

} // namespace osgTreeWind
