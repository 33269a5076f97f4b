// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/InstanceList.h>

#include <osg/Geometry>

namespace osgTreeWind {

/// One part (bark, leaves, impostors) of the trees of a list, in one instanced draw. Made by cull for a
/// frame; never part of the scene graph.
class InstancedDraw : public osg::Drawable {
public:
    InstancedDraw();

    /// @param geometry of one tree, its vertices in buffer objects; DrawElements and DrawArrays are drawn.
    /// @param isLast of a batch: the driver is told to begin, as one that draws on processors would else wait
    /// for the end of the frame.
    void set(osg::Geometry* geometry, InstanceList* trees, bool isLast = false);

    void drawImplementation(osg::RenderInfo& renderInfo) const override;

protected:
    ~InstancedDraw() override = default;

private:
    void drawTrees(osg::RenderInfo& renderInfo) const;

    osg::ref_ptr<osg::Geometry> _geometry;
    osg::ref_ptr<InstanceList> _trees;
    bool _isLast = false;
};

} // namespace osgTreeWind
