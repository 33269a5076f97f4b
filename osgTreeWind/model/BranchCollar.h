// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>

namespace osgTreeWind {

/// Where a branch leaves the bark of the unit along which it springs: a ring on that bark, wider than the
/// branch.
class BranchCollar {
public:
    /// @param bark radius of the parent's there, metres.
    BranchCollar(const Skeleton& skeleton, std::size_t unit, float bark);

    float begin() const { return _begin; } ///< On the parent's bark, in intervals between the unit's points.
    float end() const { return _end; }     ///< Where the branch is no wider than its own radius, likewise.
    /// Factor on the radius of a ring between.
    float widening(float place) const;
    /// A vertex on the parent's bark, which moves with the parent. @param aside unit vector across the
    /// branch.
    SkinVertex vertex(const glm::vec3& aside) const;

private:
    glm::vec3 _base, _along;  ///< Of the branch; the parent's axis there.
    glm::vec3 _away, _across; ///< Unit vectors across that axis: toward the branch, and beside it.
    float _sine, _cosine;     ///< Of the angle between the two.
    float _bark, _reach;      ///< Radius of the parent's bark; of the collar.
    float _begin, _end;
    int _parent;
};

} // namespace osgTreeWind
