// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/ImpostorStrip.h>
#include <osgTreeWind/drawing/instanced/OcclusionBuffer.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <osg/BoundingBox>
#include <osg/Matrixf>
#include <osg/Vec3>
#include <osgUtil/CullVisitor>

namespace osgTreeWind {

/// Projects impostors and boxes to the screen of one cull, as shaders/impostor.vert does.
class ImpostorProjection {
public:
    explicit ImpostorProjection(osgUtil::CullVisitor& visitor);

    /// Without coverage if the tree surrounds the eye or extends behind it, or if the camera is rolled.
    OcclusionBuffer::Billboard project(const PlacedTree& tree, const glm::vec2& lean,
                                       const ImpostorStrip& impostor) const;
    /// The bounding rectangle of a box on the screen. @return false if a corner is behind the eye.
    bool project(const osg::BoundingBox& box, osg::Vec2& low, osg::Vec2& high) const;
    const osg::Matrixf& toClip() const { return _toClip; } ///< From the forest's frame.
    /// Distance of a point from the eye, metres; forest's frame.
    float distance(const osg::Vec3& point) const { return (point - _eye).length(); }

    /// Direction from a point toward the eye, of any length; forest's frame.
    osg::Vec3 towardEye(const osg::Vec3& point) const {
        return _parallelDirection.length2() > 0.0f ? _parallelDirection : _eye - point;
    }

private:
    osg::Matrixf _toClip;
    osg::Vec3 _eye, _parallelDirection; ///< Direction toward the eye in a parallel projection; else zero.
};

} // namespace osgTreeWind
