// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/DrawingOptions.h>

#include <osg/Vec3>

#include <cmath>

namespace osgTreeWind {

/// The levels of detail at which a tree is drawn, finest first.
enum class Tier {
    Full,
    Sprays,      ///< All leaf cards, bark no finer than pixels.
    Boughs,      ///< Cards of boughs instead of sprays.
    FewerBoughs, ///< Fewer and larger cards from here on.
    FewBoughs,
    FewestBoughs,
    Impostor,              ///< A picture of the tree with all its leaves.
    ImpostorThreeQuarters, ///< With three quarters of the leaves, and so on.
    ImpostorHalf,
    ImpostorQuarter,
    BareImpostor
};
constexpr int tierCount = 11;
constexpr int branchTiers = 6; ///< Number of tiers with branches, from Full on.
constexpr int leafTiers = 2;   ///< Number of tiers with all leaf sprays, from Full on.
constexpr int impostorTiers = tierCount - branchTiers;

/// Linear colour of a tier under TIERS_COLORED (shaders/scene.glsl): red, yellow to green, blue for
/// impostors.
inline osg::Vec3 tierColor(Tier tier) {
    const int index = static_cast<int>(tier);
    if (index >= branchTiers)
        return {0.05f, 0.15f, 1.0f};
    const float coarse = static_cast<float>(index) / (branchTiers - 1);
    return tier == Tier::Full ? osg::Vec3(1.0f, 0.05f, 0.05f) : osg::Vec3(1.0f - coarse, 0.8f, 0.05f);
}

/// The impostor that is nearest to a tree with this share of its leaves, [0, 1].
inline Tier impostorTier(float leaves) {
    return static_cast<Tier>(static_cast<int>(Tier::BareImpostor) -
                             static_cast<int>(std::lround(4.0f * leaves)));
}
/// The share of leaves that an impostor shows.
inline float shownLeafShare(Tier impostor) {
    return 0.25f * static_cast<float>(static_cast<int>(Tier::BareImpostor) - static_cast<int>(impostor));
}

/// The tier of a tree, or two adjacent tiers during a transition.
struct TierChoice {
    Tier tier = Tier::Full;
    /// 1 outside a transition. Else the share of leaf cards that this tier draws, or of pixels if the next
    /// tier is an impostor. The next coarser tier draws the rest.
    float fade = 1.0f;
};

/// Chooses tiers by the height of a tree on the screen.
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
    /// Height above which a tree needs ModalMotion::Level::Near, a little below that at which branches
    /// appear.
    float fullMotionPixels() const { return 0.85f * _to[branchTiers - 1]; }
    /// If false, all trees are drawn at Tier::Full.
    bool areEnabled() const { return _enabled; }

private:
    bool _enabled;
    float _from[branchTiers], _to[branchTiers],
        _perPixel[branchTiers]; // each tier fades between _from and _to
};

} // namespace osgTreeWind
