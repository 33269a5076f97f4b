// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/NoiseTime.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/motion/laws/Laws.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

NoiseTime split(double periods) {
    if (!std::isfinite(periods))
        return {};
    const double cell = std::floor(periods);
    const float fraction = static_cast<float>(periods - cell);
    const double wrapped = cell - 4294967296.0 * std::floor(cell / 4294967296.0);
    if (fraction >= 1.0f) // the conversion to float rounded up
        return {static_cast<std::uint32_t>(static_cast<std::uint64_t>(wrapped) + 1), 0.0f, 0.0f};
    return {static_cast<std::uint32_t>(static_cast<std::uint64_t>(wrapped)), fraction, 0.0f};
}

} // namespace

NoiseTime NoiseTime::at(double time, float frequency, std::optional<float> exponent) {
    const double periods = time * static_cast<double>(frequency);
    if (!exponent || !std::isfinite(*exponent))
        return split(periods);
    NoiseTime now = split(periods * static_cast<double>(Laws().slowestOctave()));
    now.gain = math::pow(2.0f, 0.5f * (1.0f - std::clamp(*exponent, static_cast<float>(noiseExponents.min),
                                                         static_cast<float>(noiseExponents.max))));
    return now;
}

} // namespace osgTreeWind
