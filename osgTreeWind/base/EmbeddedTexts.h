// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace osgTreeWind {

/// A source file that was compiled into the library or a program.
struct EmbeddedText {
    std::string name; ///< Relative to the repository, e.g. "shaders/law/noise.glsl".
    std::string text;
};

/// All embedded files: the shaders and the species catalogue. Generated at build time.
const std::vector<EmbeddedText>& embeddedTexts();

/// The embedded file with that name, or null.
inline const EmbeddedText* findEmbeddedText(const std::string& name,
                                            const std::vector<EmbeddedText>& texts = embeddedTexts()) {
    for (const EmbeddedText& embedded : texts)
        if (embedded.name == name)
            return &embedded;
    return nullptr;
}

} // namespace osgTreeWind
