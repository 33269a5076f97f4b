// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/TreeTiers.h>

#include <algorithm>

namespace osgTreeWind {

TreeTiers::TreeTiers(const DrawingOptions& drawing) : _on(drawing.tiers) {
    const float step = std::cbrt(drawing.reduced / std::max(drawing.full, 1.0e-6f));
    const float heights[branchTiers] = {4.0f * drawing.full,        drawing.full,    drawing.full * step,
                                        drawing.full * step * step, drawing.reduced, drawing.impostor};
    for (int tier = 0; tier < branchTiers; ++tier) {
        _from[tier] = drawing.tiers ? heights[tier] : 0.0f;
        const bool isAlike =
            tier == static_cast<int>(Tier::Full); // as the next one but for a few pixels of bark
        _to[tier] = _from[tier] * (isAlike ? 1.0f : 1.0f - drawing.blend);
        _perPixel[tier] = 1.0f / std::max(_from[tier] - _to[tier], 1.0e-6f);
    }
}

} // namespace osgTreeWind
