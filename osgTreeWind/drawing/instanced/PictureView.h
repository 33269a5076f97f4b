// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/ImpostorStrip.h>
#include <osgTreeWind/drawing/instanced/ScreenCover.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <osg/BoundingBox>
#include <osg/Matrixf>
#include <osg/Vec3>
#include <osgUtil/CullVisitor>

namespace osgTreeWind {

/// Where the pictures of trees are on the screen of one cull, as shaders/impostor.vert puts them.
class PictureView {
public:
    explicit PictureView(osgUtil::CullVisitor& visitor);

    /// Without a cover where none can be told: the tree is about the eye or reaches behind it, or the view is
    /// turned on its side.
    ScreenCover::Picture place(const PlacedTree& tree, const glm::vec2& lean,
                               const ImpostorStrip& impostor) const;
    /// The part of the screen that a box is on; false where some of it is not before the eye.
    bool place(const osg::BoundingBox& box, osg::Vec2& low, osg::Vec2& high) const;
    /// Share of the screen that a pixel is.
    float pixel() const { return _pixel; }
    /// From the eye to a point, metres; forests' frame.
    float distance(const osg::Vec3& point) const { return (point - _eye).length(); }

    /// From a point to the eye, of any length; forests' frame.
    osg::Vec3 towardEye(const osg::Vec3& point) const {
        return _parallel.length2() > 0.0f ? _parallel : _eye - point;
    }

private:
    osg::Matrixf _toClip;
    float _pixel;
    osg::Vec3 _eye, _parallel; ///< The latter toward the eye of a parallel projection, else null.
};

} // namespace osgTreeWind
