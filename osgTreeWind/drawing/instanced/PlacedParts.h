// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/FrontToBackQueue.h>
#include <osgTreeWind/drawing/instanced/ImpostorProjection.h>
#include <osgTreeWind/drawing/instanced/MeshParts.h>
#include <osgTreeWind/drawing/instanced/ViewFrustum.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <array>

namespace osgTreeWind {

/// Culls the parts of one tree against the view, and projects them to the screen.
class PlacedParts {
public:
    /// @param lean displacement of the treetop by the wind, metres, the forest's frame.
    /// @param height of the tree, metres.
    PlacedParts(const ViewFrustum& view, const ImpostorProjection& projection, const PlacedTree& tree,
                const glm::vec2& lean, float height);

    /// Sets the scale of what the next parts bear around branches: of radii or of leaves.
    void setReachScale(float scale) { _beyond = glm::abs(scale - _axes) / _axes; }

    /// Whether a swaying part may be in view; conservative.
    bool isInView(const MeshPart& part) const;
    /// Distance of its nearest point from the eye, metres; less if the part is large.
    float distance(const MeshPart& part) const;
    /// The place on the screen of a part. @param cover factor on its projected area.
    /// @return false if it surrounds the eye or extends behind it.
    bool project(const MeshPart& part, float cover, OcclusionBuffer::Rectangle& place) const;

private:
    glm::vec3 centreOf(const MeshPart& part) const;     ///< In the forest's frame, with the lean.
    glm::vec3 halfExtentOf(const MeshPart& part) const; ///< In the frame of the unscaled tree.

    const ImpostorProjection& _projection;
    glm::mat3 _toForest; ///< From the unscaled tree.
    glm::vec3 _foot, _lean;
    struct Plane {
        glm::vec3 normal;
        float offset; ///< With the sway toward the plane.
    };
    std::array<Plane, 32> _planes; ///< In the frame of the unscaled tree.
    std::size_t _planeCount = 0;
    std::array<glm::vec3, 3> _extents; ///< In clip space along x, y and w: of each axis of the unscaled tree.
    float _squareMetre;                ///< Area of 1 m² in clip space; a mean if the axes differ in scale.
    glm::vec3 _axes;                   ///< Scale of the tree.
    glm::vec3 _beyond{0.0f};           ///< How far parts may leave their boxes, over their reach.
};

} // namespace osgTreeWind
