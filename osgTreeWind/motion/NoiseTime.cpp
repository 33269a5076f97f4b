// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/NoiseTime.h>

#include <cmath>

namespace osgTreeWind {

NoiseTime NoiseTime::at(double time, float frequency) {
    const double periods = time * static_cast<double>(frequency);
    if (!std::isfinite(periods))
        return {};
    const double cell = std::floor(periods);
    const float fraction = static_cast<float>(periods - cell);
    const double wrapped = cell - 4294967296.0 * std::floor(cell / 4294967296.0);
    if (fraction >= 1.0f) // rounded up from just below
        return {static_cast<std::uint32_t>(static_cast<std::uint64_t>(wrapped) + 1), 0.0f};
    return {static_cast<std::uint32_t>(static_cast<std::uint64_t>(wrapped)), fraction};
}

} // namespace osgTreeWind
