// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/GivenWind.h>

#include <osgTreeWind/wind/WindSampler.h>

#include <utility>

namespace osgTreeWind {

GivenWind::GivenWind(Wind given) : _given(std::make_shared<const Wind>(std::move(given))) {}

void GivenWind::set(Wind given) {
    const auto next = std::make_shared<Wind>(std::move(given));
    std::shared_ptr<const Wind> before = next; // goes after the lock, with the old field
    const std::lock_guard<std::mutex> lock(_mutex);
    if (!next->canopy)
        next->canopy = _given->canopy;
    std::swap(_given, before);
}

std::shared_ptr<const Wind> GivenWind::get() const {
    const std::lock_guard<std::mutex> lock(_mutex);
    return _given;
}

WindFieldPtr GivenWind::here() {
    const std::shared_ptr<const Wind> given = get();
    if (given != _metGiven || _place != _metPlace) {
        _metGiven = given;
        _metPlace = _place;
        _met = asField(given, _place);
    }
    return _met;
}

} // namespace osgTreeWind
