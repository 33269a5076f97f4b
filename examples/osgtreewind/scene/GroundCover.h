// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Image>
#include <osg/StateSet>
#include <osg/Texture2D>
#include <osg/Vec2d>

/// Map of how trees cover the ground: where crowns close over it, and where trunks hide the sky. It shows the
/// trees at the time of its construction. It is empty for worlds, because their trees are loaded and
/// unloaded.
class GroundCover {
public:
    explicit GroundCover(const osgTreeWind::Forest& forest);

    bool isEmpty() const { return !_image; }
    /// Share of the sky hidden by crowns at a place, 0 to 1.
    float crownsOver(const osg::Vec2d& place) const;
    /// Share of the sky hidden by the nearest trunk, 0 to 0.5.
    float trunkAt(const osg::Vec2d& place) const;
    /// Sets the texture `groundCover` and the uniform `coverPlace` for the shaders of Ground.h, unless empty.
    void setUniforms(osg::StateSet& state, unsigned unit) const;

private:
    float channelAt(const osg::Vec2d& place, int channel) const;

    osg::Vec2d _low;
    double _cell = 1.0;
    osg::ref_ptr<osg::Image> _image; ///< Two bytes per texel.
    osg::ref_ptr<osg::Texture2D> _texture;
};
