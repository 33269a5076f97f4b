// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/LeafFall.h>

#include <osgTreeWind/species/Season.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

constexpr float stripping = 33.0f; // m/s

} // namespace

float LeafFall::ahead(float speed) const {
    const auto force = [&](float wind) { return wind * wind * _foliage.drag(wind); };
    return most * std::min(force(std::min(speed, stripping)) / force(stripping), 1.0f);
}

float LeafFall::share(float season, float ahead) const {
    return std::min(leafShare(*_appearance, season), leafShare(*_appearance, season + ahead));
}

} // namespace osgTreeWind
