// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/laws/Reconfiguration.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// Early leaf fall in gusts (docs/risk.md, "Leaves").
///
/// The attachment of a leaf weakens linearly over the fortnight before it falls, from the drag at 33 m/s,
/// which strips trees in full leaf, down to zero. A gust takes all leaves weaker than its drag.
class LeafFall {
public:
    /// @param species must outlive it.
    explicit LeafFall(const Species& species) : _appearance(&species.appearance), _foliage(species) {}

    /// Share of the year (Season.h) by which leaves fall early in a wind, [0, maxAdvance]. @param speed m/s.
    float seasonAdvance(float speed) const;
    static constexpr float maxAdvance = 14.0f / 91.3125f;

    /// Share of its leaves that a tree still bears. @param ahead the largest seasonAdvance() so far.
    float remainingShare(float season, float ahead) const;
    /// Whether a wind could take leaves at this time of year.
    bool hasLooseLeaves(float season) const {
        return remainingShare(season, maxAdvance) < remainingShare(season, 0.0f);
    }

private:
    const Appearance* _appearance;
    Reconfiguration _foliage;
};

} // namespace osgTreeWind
