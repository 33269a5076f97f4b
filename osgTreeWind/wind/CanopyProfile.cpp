// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/CanopyProfile.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr float karman = 0.4f;
// Raupach 1994: drag of bare ground and of roughness elements, largest u*/U(h), and what parts d from h.
constexpr float groundDrag = 0.003f, elementDrag = 0.3f, mostFriction = 0.3f, displacing = 7.5f;

/// Over u*: in a canopy and at its top (Raupach, Finnigan and Brunet 1996), and in the surface
/// layer above (Panofsky and Dutton 1984).
constexpr WindSpread inCanopy{1.8f, 1.6f, 1.1f}, inSurfaceLayer{2.4f, 1.9f, 1.25f};
/// Within the canopy they fall as exp(-1.6 (1 - z/h)): to a half at 0.57 h (the same).
constexpr float spreadAttenuation = 1.6f;
/// Of the order of 1 in a canopy, small well above (the same).
constexpr float canopySkewness = 1.0f;

/// 0 at the top of the canopy, 1 from twice its height on.
float shareAbove(float z, float height) {
    return std::min(std::max(0.0f, z / height - 1.0f), 1.0f);
}

} // namespace

CanopyProfile CanopyProfile::over(float height, float frontalArea) {
    const float area = std::max(frontalArea, 1e-4f), x = std::sqrt(2.0f * displacing * area);
    CanopyProfile profile;
    profile.height = height;
    profile.friction = std::min(std::sqrt(groundDrag + elementDrag * area), mostFriction);
    // 1 - d/h; the wind's slope at the top is then that of the sublayer, u* / (2 kappa (h - d)).
    const float gap = (1.0f - std::exp(-x)) / x;
    profile.attenuation = profile.friction / (2.0f * karman * gap);
    return profile;
}

float CanopyProfile::displacement() const {
    return 1.0f - friction / (2.0f * karman * attenuation);
}

float CanopyProfile::mean(float z) const {
    if (!(z > height))
        return std::exp(-attenuation * (1.0f - std::max(0.0f, z) / height));
    const float gap = height * (1.0f - displacement()); // also how deep the sublayer is
    const float sublayer = std::min((z - height) / gap, 1.0f);
    const float log = std::log(std::max((std::min(z, 1e6f) - height + gap) / (2.0f * gap), 1.0f));
    return 1.0f + friction / karman * (0.5f * sublayer + log);
}

WindSpread CanopyProfile::spread(float z) const {
    const float up = shareAbove(z, height),
                share =
                    friction *
                    (z < height ? std::exp(-spreadAttenuation * (1.0f - std::max(0.0f, z) / height)) : 1.0f);
    const auto at = [&](float low, float high) { return share * (low + up * (high - low)); };
    return {at(inCanopy.along, inSurfaceLayer.along), at(inCanopy.across, inSurfaceLayer.across),
            at(inCanopy.up, inSurfaceLayer.up)};
}

float CanopyProfile::skewness(float z) const {
    return canopySkewness * (1.0f - shareAbove(z, height));
}

float closureOf(float frontalArea) {
    const float closed = mostFriction * mostFriction - groundDrag;
    return std::clamp(elementDrag * frontalArea / closed, 0.0f, 1.0f);
}

} // namespace osgTreeWind
