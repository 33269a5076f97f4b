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
    glm::vec3 centre{0.0f};  ///< Point of the skeleton it belongs to (rigid skinning: exactly one).
    float radius = 0.0f;     ///< Metres.
    glm::vec3 outward{0.0f}; ///< Unit normal, across the tangent of the branch.
    float unit = 0.0f;       ///< Index of the branch unit (exact as a float below 2^24).
    glm::vec2 uv{
        0.0f}; ///< Once around the branch; metres along it over its circumference, from its parent's end on.

    glm::vec3 position() const { return centre + radius * outward; }
};

/// How much of a skin is made.
struct SkinDetail {
    int rings = 1 << 30; ///< Of a unit, its two ends among them, >= 2; at most those of the skeleton.
    int sides = 8;       ///< Vertices of a ring, >= 3.
};

/// The surface of a tree's wood: rings of eight around every skeleton point (thesis §2.3), or fewer.
struct BranchSkin {
    static constexpr int verticesPerRing = SkinDetail().sides; ///< Of the whole skin.

    std::vector<SkinVertex> vertices;   ///< The thesis' `vertices`: a ring per skeleton point.
    std::vector<std::uint32_t> indices; ///< Triangles, counter-clockwise seen from outside, unit after unit.

    /// Indices used by one unit.
    std::size_t indicesPerUnit = 0;

    /// The thesis' `newArr` (§2.3.5): vertices in the order in which triangles use them.
    std::vector<SkinVertex> drawOrder() const;
};

/// The foot of the stem is wider by the skeleton's flare, in five roots, up to 1.2 m or a tenth of the tree.
/// @param detail fewer sides stand farther out, so that a branch is as wide as ever in the mean over all
/// directions it is seen from.
BranchSkin makeBranchSkin(const Skeleton& skeleton, const SkinDetail& detail = {});

} // namespace osgTreeWind
