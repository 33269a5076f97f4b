// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/CanopyProfile.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/wind/LogProfile.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr float karman = 0.4f;
// Raupach 1994: drag of bare ground and of roughness elements, maximum u*/U(h), parameter of d/h.
constexpr float groundDrag = 0.003f, elementDrag = 0.3f, maxFriction = 0.3f, displacementParameter = 7.5f;

/// Deviations over u* in the surface layer (Panofsky and Dutton 1984).
constexpr WindSpread inSurfaceLayer{2.4f, 1.9f, 1.25f};
/// In the canopy deviations fall as exp(-1.6 (1 - z/h)), to a half at 0.57 h (Raupach et al. 1996).
constexpr float spreadAttenuation = 1.6f;
/// About 1 in a canopy, small well above it (Raupach et al. 1996).
constexpr float canopySkewness = 1.0f;

/// 0 at the canopy top, 1 at twice its height and above.
float surfaceLayerShare(float z, float height) {
    return std::min(std::max(0.0f, z / height - 1.0f), 1.0f);
}

} // namespace

CanopyProfile CanopyProfile::ofStand(float height, float frontalArea) {
    const float area = std::max(frontalArea, 1e-4f), x = std::sqrt(2.0f * displacementParameter * area);
    CanopyProfile profile;
    profile.height = height;
    profile.friction = std::min(std::sqrt(groundDrag + elementDrag * area), maxFriction);
    // 1 - d/h. The slope of the profile at the top is that of the sublayer, u* / (2 kappa (h - d)).
    const float gap = (1.0f - math::exp(-x)) / x;
    profile.attenuation = profile.friction / (2.0f * karman * gap);
    return profile;
}

float CanopyProfile::displacement() const {
    return 1.0f - friction / (2.0f * karman * attenuation);
}

float CanopyProfile::roughness() const {
    return 2.0f * height * (1.0f - displacement()) * math::exp(-karman / friction - 0.5f);
}

float CanopyProfile::topSpeedRatio(float reference, float extent) const {
    constexpr auto open = static_cast<float>(openCountryRoughness);
    const float rough = roughness(), fetch = 0.5f * extent; // mean distance to the edge of a square
    const float slowed =
        rough * (0.75f - 0.03f * math::log(rough / open)) * math::pow(fetch / rough, 0.8f); // above d
    const float layer = slowed + height * displacement(), ratio = 1.0f / mean(reference);
    if (!(layer > reference))
        return ratio;
    // u* over that of open country: winds are equal at the top of the layer
    const float frictions =
        std::max(math::log(layer / open) / math::log(slowed / rough), math::pow(rough / open, 0.07f));
    return std::min(frictions * karman / (friction * math::log(reference / open)), ratio);
}

float CanopyProfile::mean(float z) const {
    if (!(z > height))
        return math::exp(-attenuation * (1.0f - std::max(0.0f, z) / height));
    const float gap = height * (1.0f - displacement()); // also the depth of the sublayer
    const float sublayer = std::min((z - height) / gap, 1.0f);
    const float log = math::log(std::max((std::min(z, 1e6f) - height + gap) / (2.0f * gap), 1.0f));
    return 1.0f + friction / karman * (0.5f * sublayer + log);
}

WindSpread CanopyProfile::spread(float z) const {
    const float up = surfaceLayerShare(z, height),
                share =
                    friction *
                    (z < height ? math::exp(-spreadAttenuation * (1.0f - std::max(0.0f, z) / height)) : 1.0f);
    const auto at = [&](float low, float high) { return share * (low + up * (high - low)); };
    return {at(spreadAtTop.along, inSurfaceLayer.along), at(spreadAtTop.across, inSurfaceLayer.across),
            at(spreadAtTop.up, inSurfaceLayer.up)};
}

float CanopyProfile::skewness(float z) const {
    return canopySkewness * (1.0f - surfaceLayerShare(z, height));
}

float closureOf(float frontalArea) {
    const float closed = maxFriction * maxFriction - groundDrag;
    return std::clamp(elementDrag * frontalArea / closed, 0.0f, 1.0f);
}

} // namespace osgTreeWind
