// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// A vertex of the bark. Its rest position is centre + radius * outward; keeping the two apart lets one
/// skin serve trees of different trunk diameter.
struct SkinVertex {
    glm::vec3 centre{0.0f};  ///< Point on a centre line.
    float radius = 0.0f;     ///< Metres.
    glm::vec3 outward{0.0f}; ///< Unit normal; across the tangent of the branch, but along it at a closed tip.
    float unit = 0.0f;       ///< Branch unit it moves with (rigid skinning; exact as a float below 2^24).
    /// From 0 to 2 around the branch, and 0 again: shaders/bark_texture.glsl; metres along it over its
    /// circumference, from its parent's end on.
    glm::vec2 uv{0.0f};

    glm::vec3 position() const { return centre + radius * outward; } ///< Of the vertex.
};

/// The surface of a tree's wood: rings around its skeleton points (thesis §2.3).
struct BranchSkin {
    static constexpr int verticesPerRing = 8; ///< Of a whole skin that is not joined.

    std::vector<SkinVertex> vertices;   ///< The thesis' `vertices`: a ring per skeleton point.
    std::vector<std::uint32_t> indices; ///< Triangles, counter-clockwise seen from outside, unit after unit.

    /// Where the vertices of each unit begin; one more for the end of the last.
    std::vector<std::uint32_t> firstVertices{0};
    std::vector<std::uint32_t> firstIndices{0}; ///< The same of its indices.

    /// The thesis' `newArr` (§2.3.5): vertices in the order in which triangles use them.
    std::vector<SkinVertex> drawOrder() const;
};

/// Rings of a skeleton that is not joined lie across the branch at its radius, one a point, and units are
/// open tubes. Of a joined one,
/// - a unit that springs from its parent's end (the next of an axis, or a limb of a fork) begins with the
///   parent's last ring, and moves with it there, so that no wind opens the joint;
/// - one that springs along its parent begins with a collar on the parent's bark, likewise;
/// - where nothing goes on the end is closed;
/// - the foot of the stem widens by the skeleton's flare, up to 1.2 m or a tenth of the tree: StemFoot.h.
/// Shoots follow the unit that bears them, as prisms of three sides: ShootSkin.h.
/// @param tolerance metres, >= 0, by which sides may be off, and twice that for the way between rings: fewer
/// of both, and no tips, feet and collars that would hardly be larger. Fewer sides stand farther out, so that
/// a branch is as wide as ever in the mean over all directions it is seen from. 0: the whole skin.
/// @param thinnestShoot metres: shoots whose radius at the base is below are left out.
BranchSkin makeBranchSkin(const Skeleton& skeleton, float tolerance = 0.0f, float thinnestShoot = 0.0f);

/// Numbers of the vertices and triangles of a whole skin, without making it.
struct SkinSize {
    std::uint64_t vertices = 0;  ///< Of all units.
    std::uint64_t triangles = 0; ///< Of all units.
};
SkinSize sizeOfBranchSkin(const Skeleton& skeleton);

} // namespace osgTreeWind
