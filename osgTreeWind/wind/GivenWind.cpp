// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/GivenWind.h>

#include <osgTreeWind/wind/MovedWind.h>

namespace osgTreeWind {

void GivenWind::set(FramedWind given) {
    const std::lock_guard<std::mutex> lock(_mutex);
    std::swap(_given, given); // the old field goes when the parameter does, after the lock
}

FramedWind GivenWind::get() const {
    const std::lock_guard<std::mutex> lock(_mutex);
    return _given;
}

WindFieldPtr GivenWind::here() {
    const FramedWind given = get();
    if (!given.wind || given.frame == WindFrame::Forest || _place == glm::dmat4(1.0))
        return given.wind;
    if (!(given == _metGiven) || _place != _metPlace) {
        _metGiven = given;
        _metPlace = _place;
        _met = std::make_shared<MovedWind>(given.wind, _place,
                                           given.frame == WindFrame::Geocentric ? MovedWind::Up::OfTheFrame
                                                                                : MovedWind::Up::OfTheWorld);
    }
    return _met;
}

} // namespace osgTreeWind
