// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Camera>
#include <osg/Group>
#include <osg/TexGen>

#include <array>

/// A group whose casters throw the sun's shadows on all that is in it. One shadow map holds what is near the
/// eye, the other what is far; both follow the view. It stands at the scene's root, and is seen by one
/// camera.
class SunShadows : public osg::Group {
public:
    SunShadows(osg::Node* casters, const osg::Vec3& toSun);

    /// The defines of shaders/scene.glsl, for what has no forest to set them.
    static void setDefines(osg::StateSet& state);

    void traverse(osg::NodeVisitor& visitor) override;
    void releaseGLObjects(osg::State* state) const override;

private:
    static constexpr int firstUnit = 1; ///< Of textures; a forest takes 0 and those from 4 on.

    /// What the sun sees of a part of the view.
    struct Map {
        osg::ref_ptr<osg::Camera> camera = new osg::Camera;
        osg::ref_ptr<osg::TexGen> planes = new osg::TexGen;
        double reach; ///< How far from the eye it is of use, metres.
    };
    void follow(Map& map, const osg::CullStack& view) const;

    osg::ref_ptr<osg::Node> _casters;
    osg::Vec3d _toSun;
    std::array<Map, 2> _maps;
};
