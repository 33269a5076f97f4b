// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/stand/TreeTiers.h>

#include <algorithm>

namespace osgTreeWind {

TreeTiers::TreeTiers(const DrawingOptions& drawing) : _on(drawing.tiers) {
    const float step = std::cbrt(drawing.reduced / std::max(drawing.full, 1.0e-6f));
    const float heights[branchTiers] = {drawing.full, drawing.full * step, drawing.full * step * step,
                                        drawing.reduced, drawing.impostor};
    for (int tier = 0; tier < branchTiers; ++tier) {
        _from[tier] = drawing.tiers ? heights[tier] : 0.0f;
        _to[tier] = drawing.tiers ? heights[tier] * (1.0f - drawing.blend) : 0.0f;
        _perPixel[tier] = 1.0f / std::max(_from[tier] - _to[tier], 1.0e-6f);
    }
}

} // namespace osgTreeWind
