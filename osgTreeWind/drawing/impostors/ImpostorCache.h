// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/ImpostorPainter.h>

namespace osgTreeWind {

/// Result of paintImpostor(), from the user's cache (base/UserCache.h) where possible. The key consists of
/// the model's leaves and skeleton, the appearance, the content of its textures and the settings. Any thread.
ImpostorPictures cachedImpostor(const TreeModel& model, const Appearance& appearance,
                                const ImpostorSettings& settings = {});

} // namespace osgTreeWind
