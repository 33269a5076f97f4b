// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindAdjustment.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr double fullTurn = glm::two_pi<double>();

double clampFinite(double value, double low, double high, double fallback) {
    return std::isfinite(value) ? std::clamp(value, low, high) : fallback;
}

} // namespace

glm::mat3 WindAdjustment::matrix() const {
    const double factor = clampFinite(strength, 0.0, 10.0, 1.0),
                 angle = clampFinite(static_cast<double>(turn), -fullTurn, fullTurn, 0.0);
    const auto along = static_cast<float>(factor * math::cos(angle)),
               right = static_cast<float>(factor * math::sin(angle)), up = static_cast<float>(factor);
    return {{along, -right, 0.0f}, {right, along, 0.0f}, {0.0f, 0.0f, up}};
}

} // namespace osgTreeWind
