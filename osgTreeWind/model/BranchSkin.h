// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// A vertex of the bark, at centre + radius * outward at rest. Centre and radius are separate, so that one
/// skin serves trees of different trunk diameter.
struct SkinVertex {
    glm::vec3 centre{0.0f};  ///< Point on a centre line, or beside it at the foot of a stem.
    float radius = 0.0f;     ///< Metres.
    glm::vec3 outward{0.0f}; ///< Unit normal, perpendicular to the branch; along it at a closed tip.
    float unit = 0.0f;       ///< Branch unit it moves with (rigid skinning; exact as a float below 2^24).
    /// u: from 0 to 2 and back to 0 around the branch (shaders/bark_texture.glsl). v: length along the branch
    /// over its circumference, or that of `thickRadius` if that is less, continued from the parent.
    glm::vec2 uv{0.0f};

    glm::vec3 position() const { return centre + radius * outward; }
};

/// The surface of a tree's wood: rings around its skeleton points (thesis §2.3).
struct BranchSkin {
    static constexpr int verticesPerRing = 8;    ///< At full detail, of a skeleton that is not joined.
    static constexpr float thickRadius = 0.175f; ///< From here on, bark has one size along the stem, metres.

    std::vector<SkinVertex> vertices;   ///< The thesis' `vertices`: a ring per skeleton point.
    std::vector<std::uint32_t> indices; ///< Triangles, counter-clockwise seen from outside, unit after unit.

    /// First vertex of each unit, and the end of the last one.
    std::vector<std::uint32_t> firstVertices{0};
    std::vector<std::uint32_t> firstIndices{0}; ///< The same for indices.

    /// Appends the vertices and triangles of another skin's unit.
    void append(const BranchSkin& other, std::size_t unit);
    /// Ends a unit: all vertices and triangles since the last one belong to it.
    void endUnit();

    /// The thesis' `newArr` (§2.3.5): vertices in the order in which triangles use them.
    std::vector<SkinVertex> drawOrder() const;
};

/// Makes the bark of a skeleton. If the skeleton is not joined, units are open tubes with a ring per point.
/// If it is joined:
/// - a unit that springs from its parent's end (the next of an axis, or a limb of a fork) begins with the
///   parent's last ring, which moves with the parent, so that the joint never opens;
/// - a unit that springs along its parent begins with a collar on the parent's bark, which moves with the
/// parent;
/// - a free end is closed;
/// - the foot of the stem widens by the skeleton's flare over 1.2 m or a tenth of the tree (StemFoot.h).
/// Shoots follow the unit that bears them, as three-sided prisms.
/// @param tolerance allowed error of the outline, metres, >= 0; twice that along the branch. It reduces sides
/// and rings, and omits small tips, feet and collars. Rings with fewer sides are wider, so that the mean
/// width over all viewing directions stays the same. 0: full detail.
/// @param thinnestShoot shoots with a smaller base radius are omitted, metres.
BranchSkin makeBranchSkin(const Skeleton& skeleton, float tolerance = 0.0f, float thinnestShoot = 0.0f);

/// Numbers of vertices and triangles at full detail, without making the skin.
struct SkinSize {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
};
SkinSize sizeOfBranchSkin(const Skeleton& skeleton);

} // namespace osgTreeWind
