// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// A rigid piece of wood that turns about its base: a trunk segment or a branch (thesis §3.1.3).
struct BranchUnit {
    int parent = -1;         ///< Index of the unit it is attached to; -1 for the root. Always < own index.
    int level = 0;           ///< `branchLevel` of the thesis: 0 for the trunk, 1 for the first branches, ...
    glm::vec3 base{0.0f};    ///< Attach point at rest, metres, tree frame (Z up, root at the origin).
    glm::vec3 tip{0.0f};     ///< End point at rest, like `base`.
    float baseRadius = 0.0f; ///< Metres.
    float tipRadius = 0.0f;  ///< Metres.
    float attach = 1.0f;     ///< Position along its parent, (0, 1]; 1: at its end.
};

/// A part of a branch, in metres from its base; empty if `to` <= `from`.
struct BranchPart {
    float from = 0.0f; ///< Metres.
    float to = 0.0f;   ///< Metres.
};

/// A twig that has geometry and mass but no joint; it moves with a unit.
struct Shoot {
    int unit = 0;            ///< The unit that bears it, directly or through other shoots.
    int level = 1;           ///< Order of branching, as in BranchUnit.
    std::size_t first = 0;   ///< Its first point in Skeleton::shootPoints, at its base.
    std::size_t count = 2;   ///< Number of its points, at least 2.
    float baseRadius = 0.0f; ///< Metres; the radius is linear along its points.
    float tipRadius = 0.0f;  ///< Metres.
    BranchPart leafy;        ///< The part that bears leaves, if Skeleton::leafyUnits is set.
};

/// The rest geometry of a tree's wood as centre lines: the thesis' `verticesForLeaves` (§2.2).
/// Units are in depth-first access order (Fig 4.5), every parent before its children. Any source may fill it:
/// the recursive generator, a growth model, a scan.
struct OSGTREEWIND_EXPORT Skeleton {
    int ringsPerBranch = 16; ///< `numBreaks`: points of one unit, at least 2.
    /// Whether bark closes over joints, forks and tips, and has collars (BranchSkin.h); otherwise units are
    /// open tubes (thesis §2.3).
    bool joined = false;
    float flare = 0.0f;            ///< Widening of joined bark at the ground over the radius there, [0, 3].
    std::vector<BranchUnit> units; ///< In access order.
    std::vector<glm::vec3> points; ///< units.size() * ringsPerBranch, unit after unit, base to tip.
    std::vector<Shoot> shoots;     ///< Wood finer than units, in the order of the units that bear it.
    /// The part of each unit that bears leaves; empty: LeafParameters decide.
    std::vector<BranchPart> leafyUnits;
    std::vector<glm::vec3> shootPoints; ///< Shoot after shoot; metres, tree frame at rest.

    /// A point of a unit, counted from its base; not range-checked.
    const glm::vec3& point(std::size_t unit, int ring) const {
        return points[unit * static_cast<std::size_t>(ringsPerBranch) + static_cast<std::size_t>(ring)];
    }
    /// A point of a shoot, counted from its base; not range-checked.
    const glm::vec3& shootPoint(const Shoot& shoot, std::size_t i) const {
        return shootPoints[shoot.first + i];
    }
    float height() const; ///< Height of the highest unit tip, metres, at least 0.
    /// Radius at a ring: linear from baseRadius to tipRadius.
    float radius(std::size_t unit, int ring) const;
    /// Unit direction of the unit's centre line at a ring (central difference, one-sided at the ends).
    glm::vec3 tangent(std::size_t unit, int ring) const;
};

} // namespace osgTreeWind
