// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/EmbeddedTexts.h>

namespace osgTreeWind {

/// The files in scene/shaders/. Generated at build time.
const std::vector<EmbeddedText>& sceneTexts();

/// Text of the file `name` in scene/shaders/.
inline const std::string& sceneShader(const std::string& name) {
    return findEmbeddedText("examples/osgtreewind/scene/shaders/" + name, sceneTexts())->text;
}

} // namespace osgTreeWind
