// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/TreeTiers.h>

#include <osgTreeWind/base/PortableMath.h>

#include <algorithm>

namespace osgTreeWind {

TreeTiers::TreeTiers(const DrawingOptions& drawing) : _enabled(drawing.tiers) {
    const float step = math::cbrt(drawing.reduced / std::max(drawing.full, 1.0e-6f));
    const float heights[branchTiers] = {4.0f * drawing.full,        drawing.full,    drawing.full * step,
                                        drawing.full * step * step, drawing.reduced, drawing.impostor};
    for (int tier = 0; tier < branchTiers; ++tier) {
        _from[tier] = drawing.tiers ? heights[tier] : 0.0f;
        const bool hasFade = tier != static_cast<int>(Tier::Full); // Sprays look almost the same
        _to[tier] = _from[tier] * (hasFade ? 1.0f - drawing.blend : 1.0f);
        _perPixel[tier] = 1.0f / std::max(_from[tier] - _to[tier], 1.0e-6f);
    }
}

} // namespace osgTreeWind
