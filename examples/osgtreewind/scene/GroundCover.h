// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Image>
#include <osg/StateSet>
#include <osg/Texture2D>
#include <osg/Vec2d>

/// What the trees of a forest do to the ground under them: where their crowns close over it, and what the
/// feet of their trunks leave of the sky. It shows the trees as they stand when it is made. For a world,
/// whose trees come and go, it is empty.
class GroundCover {
public:
    explicit GroundCover(const osgTreeWind::Forest& forest);

    bool isEmpty() const { return !_image; }
    /// How far crowns hide the sky there, 0 to 1.
    float crownsOver(const osg::Vec2d& place) const;
    /// Sets `groundCover`, a texture, and `coverPlace` for the shaders of Ground.h, unless it is empty.
    void setUniforms(osg::StateSet& state, unsigned unit) const;

private:
    osg::Vec2d _low;
    double _cell = 1.0;
    osg::ref_ptr<osg::Image> _image; ///< Two bytes a texel.
    osg::ref_ptr<osg::Texture2D> _texture;
};
