// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindFields.h>

namespace osgTreeWind {

template <>
const Fields& fieldsOf<GustWind::Parameters>() {
    using P = GustWind::Parameters;
    static const Fields fields = {
        {"intensity", memberOf<&P::intensity>, within(0, 1), "",
         "standard deviation of the wind along the mean over the mean; across 0.8 and upward 0.5 of that. "
         "Open country 0.15, suburbs 0.25, over a forest 0.3 and more"},
        {"length_scale", memberOf<&P::lengthScale>, within(1, 1e5), "m",
         "size of the largest gusts along the wind"},
        {"seed", memberOf<&P::seed>, {}, "", "one seed, one wind; without it the `seed` of the file"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<LogProfile>() {
    using P = LogProfile;
    static const Fields fields = {
        {"height", memberOf<&P::height>, above(0, 10000), "m", ""},
        {"roughness", memberOf<&P::roughness>, above(0, 100), "m", ""},
    };
    return fields;
}

template <>
const Fields& fieldsOf<RetimedWind::Clock>() {
    using P = RetimedWind::Clock;
    static const Fields fields = {
        {"start", memberOf<&P::start>, within(-1e12, 1e12), "s",
         "time of the wind data shown when the scene's time is 0"},
        {"time_scale", memberOf<&P::scale>, within(-1e6, 1e6), "",
         "seconds of wind data per second of the scene: 60 shows an hour in a minute, 0 stands still"},
    };
    return fields;
}

} // namespace osgTreeWind
