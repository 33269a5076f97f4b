// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/ImpostorCoverage.h>
#include <osgTreeWind/drawing/impostors/ImpostorPainter.h>

#include <osg/Geometry>
#include <osg/Program>
#include <osg/StateSet>

namespace osgTreeWind {

/// Geometry and state of an impostor, shared by all trees of a model: a strip that shaders/impostor.vert
/// places by the attributes treePlace, treeSize and treeState. The state lacks the uniform leanPower.
class ImpostorStrip : public osg::Referenced {
public:
    static constexpr int colorUnit = 0,
                         normalUnit = 12; ///< Texture units; those of the host are between them.

    /// @param program sharedProgram("impostor", "impostor"), shared by all models.
    ImpostorStrip(ImpostorPictures pictures, osg::Program* program);

    /// Without images.
    const ImpostorPictures& pictures() const { return _pictures; }
    const ImpostorCoverage& coverage() const { return _coverage; }
    /// A strip of two segments, which can bend.
    osg::Geometry* geometry() const { return _geometry.get(); }
    /// A strip of one segment, for trees smaller than bendingPixels, whose bend is less than a pixel.
    osg::Geometry* straightGeometry() const { return _straight.get(); }
    static constexpr float bendingPixels = 24.0f;
    osg::StateSet* stateSet() const { return _stateSet.get(); }

private:
    ImpostorPictures _pictures;
    ImpostorCoverage _coverage;
    osg::ref_ptr<osg::Geometry> _geometry, _straight;
    osg::ref_ptr<osg::StateSet> _stateSet;
};

} // namespace osgTreeWind
