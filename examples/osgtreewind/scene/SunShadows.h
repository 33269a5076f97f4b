// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/OpenGLProfile.h>

#include <osg/Camera>
#include <osg/Group>
#include <osg/TexGen>

#include <array>

/// Group on whose children the casters cast shadows of the sun, by a shadow map for the near part of the view
/// and one for the far part. It must be the root of the scene, and only one camera may draw it.
class SunShadows : public osg::Group {
public:
    SunShadows(osg::Node* casters, const osg::Vec3& toSun);

    /// Sets the defines of shaders/scene.glsl for nodes outside a forest.
    static void setDefines(osg::StateSet& state);

    void traverse(osg::NodeVisitor& visitor) override;
    void releaseGLObjects(osg::State* state) const override;

private:
    static constexpr int firstUnit = 1; ///< Texture unit; a forest uses 0, 12 and above.

    /// Shadow map for a part of the view.
    struct Map {
        osg::ref_ptr<osg::Camera> camera = new osg::Camera;
        osg::ref_ptr<osg::TexGen> planes = new osgTreeWind::CompatibilityOnly<osg::TexGen>;
        double reach; ///< Largest distance from the eye that it covers, metres.
    };
    /// Places the camera of a map. @return whether the map holds all casters, as those after it do.
    bool follow(Map& map, const osg::CullStack& view) const;

    osg::ref_ptr<osg::Node> _casters;
    osg::Vec3d _toSun;
    std::array<Map, 2> _maps;
    bool _isSmall =
        false; ///< The casters fit into the nearest map in all views, so only the last one is drawn.
};
