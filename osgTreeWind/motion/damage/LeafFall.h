// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/laws/Reconfiguration.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// Leaves that a gust takes before they would fall by themselves (docs/risk.md, "Leaves").
///
/// A leaf's stalk loosens evenly over the fortnight before it falls, from what holds it in the wind that
/// strips trees in leaf, 33 m/s, to nothing: whatever the drag of a gust exceeds by then is gone.
class LeafFall {
public:
    /// @param species must outlive it.
    explicit LeafFall(const Species& species) : _appearance(&species.appearance), _foliage(species) {}

    /// By how much of the year (Season.h) leaves fall early in a wind of `speed`, m/s: [0, most].
    float ahead(float speed) const;
    static constexpr float most = 14.0f / 91.3125f;

    /// Share of its leaves that a tree bears then, which lost all that would have fallen up to `ahead` later.
    float share(float season, float ahead) const;
    /// Whether a wind could take any.
    bool someHangLoose(float season) const { return share(season, most) < share(season, 0.0f); }

private:
    const Appearance* _appearance;
    Reconfiguration _foliage;
};

} // namespace osgTreeWind
