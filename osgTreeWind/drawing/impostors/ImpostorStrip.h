// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/ImpostorPainter.h>
#include <osgTreeWind/drawing/impostors/PictureCover.h>

#include <osg/Geometry>
#include <osg/Program>
#include <osg/StateSet>

namespace osgTreeWind {

/// The drawn form of a tree's pictures, shared by all trees of a model: a strip that shaders/impostor.vert
/// puts where the attributes treePlace, treeSize and treeState say, and what it needs but for the uniform
/// leanPower.
class ImpostorStrip : public osg::Referenced {
public:
    static constexpr int colorUnit = 0, normalUnit = 6; ///< Texture units; shadows use those between.

    /// @param program sharedProgram("impostor", "impostor"), shared by all models.
    ImpostorStrip(ImpostorPictures pictures, osg::Program* program);

    const ImpostorPictures& pictures() const { return _pictures; }
    const PictureCover& cover() const { return _cover; }
    /// In two segments up the tree, so that it bends.
    osg::Geometry* geometry() const { return _geometry.get(); }
    /// In one, for trees smaller than that, whose bend is within a pixel.
    osg::Geometry* straight() const { return _straight.get(); }
    static constexpr float bendingPixels = 24.0f;
    osg::StateSet* stateSet() const { return _stateSet.get(); }

private:
    ImpostorPictures _pictures;
    PictureCover _cover;
    osg::ref_ptr<osg::Geometry> _geometry, _straight;
    osg::ref_ptr<osg::StateSet> _stateSet;
};

} // namespace osgTreeWind
