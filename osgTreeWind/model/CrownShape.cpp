// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/CrownShape.h>

#include <osgTreeWind/model/PortableMath.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

namespace osgTreeWind {
namespace {

float flame(float r) {
    return r <= 0.7f ? r / 0.7f : (1.0f - r) / 0.3f;
}

} // namespace

float crownWidth(CrownShape shape, float wanted) {
    const float r = glm::clamp(wanted, 0.0f, 1.0f);
    switch (shape) {
    case CrownShape::Cone:
        return 0.2f + 0.8f * r;
    case CrownShape::Sphere:
        return 0.2f + 0.8f * sine(glm::pi<float>() * r);
    case CrownShape::Hemisphere:
        return 0.2f + 0.8f * sine(glm::half_pi<float>() * r);
    case CrownShape::Cylinder:
        return 1.0f;
    case CrownShape::TaperedCylinder:
        return 0.5f + 0.5f * r;
    case CrownShape::Flame:
        return flame(r);
    case CrownShape::InverseCone:
        return 1.0f - 0.8f * r;
    case CrownShape::TendFlame:
        return 0.5f + 0.5f * flame(r);
    }
    return 1.0f;
}

} // namespace osgTreeWind
