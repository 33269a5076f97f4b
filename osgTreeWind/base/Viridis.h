// SPDX-License-Identifier: MIT
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>

namespace osgTreeWind {

/// The colour map viridis, interpolated between five colours. @param share clamped to [0, 1].
inline glm::vec3 viridis(double share) {
    constexpr int last = 4;
    static const glm::vec3 colors[last + 1] = {{0.267f, 0.005f, 0.329f},
                                               {0.229f, 0.322f, 0.546f},
                                               {0.128f, 0.567f, 0.551f},
                                               {0.369f, 0.789f, 0.383f},
                                               {0.993f, 0.906f, 0.144f}};
    const double place = std::clamp(share, 0.0, 1.0) * last;
    const int below = std::min(last - 1, static_cast<int>(place));
    return glm::mix(colors[below], colors[below + 1], static_cast<float>(place - below));
}

} // namespace osgTreeWind
