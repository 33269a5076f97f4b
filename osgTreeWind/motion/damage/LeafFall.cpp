// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/LeafFall.h>

#include <osgTreeWind/species/Season.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

constexpr float strippingSpeed = 33.0f; // m/s

} // namespace

float LeafFall::seasonAdvance(float speed) const {
    const auto force = [&](float wind) { return wind * wind * _foliage.dragRatio(wind); };
    return maxAdvance * std::min(force(std::min(speed, strippingSpeed)) / force(strippingSpeed), 1.0f);
}

float LeafFall::remainingShare(float season, float ahead) const {
    return std::min(leafShare(*_appearance, season), leafShare(*_appearance, season + ahead));
}

} // namespace osgTreeWind
