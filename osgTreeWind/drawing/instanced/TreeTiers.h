// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/DrawingOptions.h>

#include <osg/Vec3>

#include <cmath>

namespace osgTreeWind {

/// How finely a tree is drawn, finest first.
enum class Tier {
    Full,
    Sprays,      ///< All leaf cards, bark no finer than pixels.
    Boughs,      ///< Cards of boughs in place of sprays,
    FewerBoughs, ///< fewer and larger ones,
    FewBoughs,   ///< and so on.
    FewestBoughs,
    Impostor,              ///< A picture of a tree with all its leaves,
    ImpostorThreeQuarters, ///< with three quarters of them,
    ImpostorHalf,          ///< and so on.
    ImpostorQuarter,
    BareImpostor
};
constexpr int tierCount = 11;
constexpr int branchTiers = 6; ///< The first ones, which draw branches.
constexpr int leafTiers = 2;   ///< The first ones, which draw all leaf sprays.
constexpr int impostorTiers = tierCount - branchTiers;

/// Under TIERS_COLORED (shaders/scene.glsl), linear: red in full, yellow to green by what is left out, blue
/// pictures.
inline osg::Vec3 tierColor(Tier tier) {
    const int index = static_cast<int>(tier);
    if (index >= branchTiers)
        return {0.05f, 0.15f, 1.0f};
    const float coarse = static_cast<float>(index) / (branchTiers - 1);
    return tier == Tier::Full ? osg::Vec3(1.0f, 0.05f, 0.05f) : osg::Vec3(1.0f - coarse, 0.8f, 0.05f);
}

/// The nearest picture to a tree with this share of its leaves, [0, 1].
inline Tier impostorTier(float leaves) {
    return static_cast<Tier>(static_cast<int>(Tier::BareImpostor) -
                             static_cast<int>(std::lround(4.0f * leaves)));
}
/// The share that it shows.
inline float leavesOn(Tier impostor) {
    return 0.25f * static_cast<float>(static_cast<int>(Tier::BareImpostor) - static_cast<int>(impostor));
}

/// The tiers of a tree at its size on the screen: one, or two across a change-over.
struct TierChoice {
    Tier tier = Tier::Full;
    /// 1 where it is drawn alone; else its share of leaf cards, of pixels where the next tier is a picture.
    /// The next coarser tier then has the others.
    float fade = 1.0f;
};

/// Tiers by height on the screen.
class TreeTiers {
public:
    explicit TreeTiers(const DrawingOptions& drawing = {});

    TierChoice choose(float pixels) const {
        for (int tier = 0; tier < branchTiers; ++tier) {
            if (pixels >= _from[tier])
                return {static_cast<Tier>(tier), 1.0f};
            if (pixels > _to[tier])
                return {static_cast<Tier>(tier), (pixels - _to[tier]) * _perPixel[tier]};
        }
        return {Tier::Impostor, 1.0f};
    }
    /// Somewhat below the height at which branches are seen: a tree so high is to have its sway in full.
    float wakingPixels() const { return 0.85f * _to[branchTiers - 1]; }
    /// Whether there are tiers at all.
    bool on() const { return _on; }

private:
    bool _on;
    float _from[branchTiers], _to[branchTiers], _perPixel[branchTiers];
};

} // namespace osgTreeWind
