// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/PortableMath.h>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace osgTreeWind {
namespace lawText {

using namespace glm;

/// The law files of shaders/law, compiled as C++. They are included into a class body because functions there
/// are implicitly inline and may stay unused. Stateless: call Laws().thesisBranchStep(...). Not for installed
/// headers, since it needs shaders/.
struct Laws {
    using real = float;
    static real every(float x) { return x; }
    static real halvings(real n) { return intBitsToFloat((127 - int(n)) << 23); }
    static float sin(float angle) { return math::sin(angle); }
    static float cos(float angle) { return math::cos(angle); }
    static vec4 pow(const vec4& base, const vec4& exponent) {
        return {math::pow(base.x, exponent.x), math::pow(base.y, exponent.y), math::pow(base.z, exponent.z),
                math::pow(base.w, exponent.w)};
    }

#include <shaders/law/limits.glsl>

#include <shaders/law/elementary.glsl>

#include <shaders/law/noise.glsl>

#include <shaders/law/thesis_branch.glsl>

#include <shaders/law/thesis_leaf.glsl>

#include <shaders/law/flutter.glsl>

#include <shaders/law/shoot.glsl>

#include <shaders/law/rotation.glsl>

#include <shaders/law/shade.glsl>

#include <shaders/law/tint.glsl>

#include <shaders/law/oscillator.glsl>

#include <shaders/law/modal.glsl>

#include <shaders/law/reconfiguration.glsl>
};

} // namespace lawText

using lawText::Laws;

} // namespace osgTreeWind
