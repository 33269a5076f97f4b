// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/HostWind.h>

#include <osgTreeWind/wind/WindSampler.h>

#include <utility>

namespace osgTreeWind {

HostWind::HostWind(Wind given) : _wind(std::make_shared<const Wind>(std::move(given))) {}

Diagnostics HostWind::set(Wind given) {
    if (Diagnostics problems = check(given); !problems.empty())
        return problems;
    const auto next = std::make_shared<Wind>(std::move(given));
    std::shared_ptr<const Wind> before = next; // destroys the old wind after the lock is released
    const std::lock_guard<std::mutex> lock(_mutex);
    if (!next->canopy)
        next->canopy = _wind->canopy;
    std::swap(_wind, before);
    return {};
}

std::shared_ptr<const Wind> HostWind::get() const {
    const std::lock_guard<std::mutex> lock(_mutex);
    return _wind;
}

WindFieldPtr HostWind::fieldWithoutTrees() {
    const std::shared_ptr<const Wind> given = get();
    if (given != _cachedWind || _forestToScene != _cachedForestToScene) {
        _cachedWind = given;
        _cachedForestToScene = _forestToScene;
        _cachedField = asField(given, _forestToScene);
    }
    return _cachedField;
}

} // namespace osgTreeWind
