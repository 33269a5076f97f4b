// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// One rigid piece of wood that turns about its base: a trunk segment or a branch (thesis §3.1.3).
struct BranchUnit {
    int parent = -1;         ///< Index of the unit it is attached to; -1 for the root. Always < own index.
    int level = 0;           ///< `branchLevel` of the thesis: 0 for the trunk, 1 for the first branches, ...
    glm::vec3 base{0.0f};    ///< Attach point at rest, metres, tree frame (Z up, root at the origin).
    glm::vec3 tip{0.0f};     ///< End point at rest.
    float baseRadius = 0.0f; ///< Metres.
    float tipRadius = 0.0f;  ///< Metres.
    float attach = 1.0f;     ///< Where along its parent it springs, (0, 1]; 1: at its end.
};

/// A part of a branch: metres along it from its base; none if `to` is not beyond `from`.
struct BranchPart {
    float from = 0.0f; ///< Metres.
    float to = 0.0f;   ///< Likewise.
};

/// A twig that is drawn and weighed and does not turn by itself: it rides on a unit.
struct Shoot {
    int unit = 0;            ///< That bears it, itself or by other shoots.
    int level = 1;           ///< Order of branching, as of BranchUnit.
    std::size_t first = 0;   ///< Of its points in Skeleton::shootPoints,
    std::size_t count = 2;   ///< of which it has at least 2, from its base to its tip.
    float baseRadius = 0.0f; ///< Metres; linear along its points to
    float tipRadius = 0.0f;  ///< that at its tip.
    BranchPart leafy;        ///< That bears leaves, where Skeleton::leafyUnits are known.
};

/// The rest geometry of a tree's wood as centre lines: the thesis' `verticesForLeaves` (§2.2).
/// Units stand in depth-first access order (Fig 4.5); every parent comes before its children.
/// Generic: any maker (recursive generator, species form, scan) may fill it.
struct OSGTREEWIND_EXPORT Skeleton {
    int ringsPerBranch = 16; ///< `numBreaks`: points of one unit, at least 2.
    /// Bark closes over joints, forks and tips and has collars: BranchSkin.h. False: open tubes (thesis
    /// §2.3).
    bool joined = false;
    float flare = 0.0f; ///< How much wider joined bark is at the ground, over the radius there, [0, 3].
    std::vector<BranchUnit> units; ///< In access order.
    std::vector<glm::vec3> points; ///< units.size() * ringsPerBranch, unit after unit, base to tip.
    std::vector<Shoot> shoots;     ///< Finer wood than the units', in the order of the units that bear it.
    std::vector<BranchPart>
        leafyUnits; ///< The part of each unit that bears leaves; empty: LeafParameters tell.
    std::vector<glm::vec3> shootPoints; ///< Of all shoots, shoot after shoot; metres, tree frame at rest.

    /// A point of a unit, from its base on; unchecked.
    const glm::vec3& point(std::size_t unit, int ring) const {
        return points[unit * static_cast<std::size_t>(ringsPerBranch) + static_cast<std::size_t>(ring)];
    }
    /// A point of a shoot, from its base on; unchecked.
    const glm::vec3& shootPoint(const Shoot& shoot, std::size_t i) const {
        return shootPoints[shoot.first + i];
    }
    float height() const; ///< Of the highest tip of a unit, metres, at least 0.
    /// Radius at a ring: linear from baseRadius to tipRadius.
    float radius(std::size_t unit, int ring) const;
    /// Unit direction of the unit's centre line at a ring (central difference, one-sided at the ends).
    glm::vec3 tangent(std::size_t unit, int ring) const;
};

} // namespace osgTreeWind
