// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/GivenWind.h>

#include <osgTreeWind/wind/MovedWind.h>

namespace osgTreeWind {

void GivenWind::set(WindFieldPtr wind) {
    const std::lock_guard<std::mutex> lock(_mutex);
    _wind.swap(wind); // the old field goes when the parameter does, after the lock
}

WindFieldPtr GivenWind::get() const {
    const std::lock_guard<std::mutex> lock(_mutex);
    return _wind;
}

WindFieldPtr GivenWind::here() {
    const WindFieldPtr wind = get();
    if (!wind || _place == glm::dmat4(1.0))
        return wind;
    if (wind != _metWind || _place != _metPlace) {
        _metWind = wind;
        _metPlace = _place;
        _met = std::make_shared<MovedWind>(wind, _place);
    }
    return _met;
}

} // namespace osgTreeWind
