// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/CrownOutline.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

namespace osgTreeWind {
namespace {

float flame(float r) {
    return r <= 0.7f ? r / 0.7f : (1.0f - r) / 0.3f;
}

} // namespace

float crownWidth(CrownOutline outline, float wanted) {
    const float r = glm::clamp(wanted, 0.0f, 1.0f);
    switch (outline) {
    case CrownOutline::Cone:
        return 0.2f + 0.8f * r;
    case CrownOutline::Sphere:
        return 0.2f + 0.8f * sine(glm::pi<float>() * r);
    case CrownOutline::Hemisphere:
        return 0.2f + 0.8f * sine(glm::half_pi<float>() * r);
    case CrownOutline::Cylinder:
        return 1.0f;
    case CrownOutline::TaperedCylinder:
        return 0.5f + 0.5f * r;
    case CrownOutline::Flame:
        return flame(r);
    case CrownOutline::InverseCone:
        return 1.0f - 0.8f * r;
    case CrownOutline::TendFlame:
        return 0.5f + 0.5f * flame(r);
    }
    return 1.0f;
}

} // namespace osgTreeWind
