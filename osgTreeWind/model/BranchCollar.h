// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/BranchSkin.h>

namespace osgTreeWind {

/// The collar of a branch that springs along its parent: a ring on the parent's bark, wider than the branch.
class BranchCollar {
public:
    /// @param bark radius of the parent at the base of the branch, metres.
    BranchCollar(const Skeleton& skeleton, std::size_t unit, float bark);

    float begin() const { return _begin; } ///< On the parent's bark, in intervals between the unit's points.
    float end() const { return _end; }     ///< Where the branch has its own radius, in the same intervals.
    /// Factor on the radius of a ring at `place`, between begin() and end().
    float widening(float place) const;
    /// A vertex on the parent's bark, which moves with the parent. @param aside unit vector across the
    /// branch.
    SkinVertex vertex(const glm::vec3& aside) const;

private:
    glm::vec3 _base, _along;  ///< Base of the branch; axis of the parent there.
    glm::vec3 _away, _across; ///< Unit vectors perpendicular to that axis: toward the branch, and sideways.
    float _sine, _cosine;     ///< Of the angle between branch and parent.
    float _bark, _reach;      ///< Radius of the parent's bark; radius of the collar.
    float _begin, _end;
    int _parent;
};

} // namespace osgTreeWind
