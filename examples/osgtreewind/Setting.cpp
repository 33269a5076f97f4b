// SPDX-License-Identifier: MIT
#include "Setting.h"

#include "Ground.h"
#include "GroundShadows.h"

#include <osg/ColorMask>
#include <osg/Depth>
#include <osg/Fog>
#include <osg/Geometry>
#include <osg/LightSource>
#include <osgShadow/ShadowMap>
#include <osgShadow/ShadowedScene>

namespace {

using osgTreeWind::Forest;

const osg::Vec3 sunDirection(0.45f, -0.5f, 0.74f); // toward the sun, unit length to 1 %
constexpr unsigned castsShadow = 0x1, shadowUnit = 7;

const char* skyVertex = R"(#version 330 compatibility
out vec3 ray;
void main() {
    vec4 eye = gl_ProjectionMatrixInverse * vec4(gl_Vertex.xy, 1.0, 1.0);
    ray = mat3(gl_ModelViewMatrixInverse) * (eye.xyz / eye.w);
    gl_Position = vec4(gl_Vertex.xy, 1.0, 1.0);
})";

const char* skyFragment = R"(#version 330 compatibility
in vec3 ray;
uniform vec3 sunDirection;
void main() {
    vec3 way = normalize(ray);
    float up = clamp(way.z, 0.0, 1.0);
    vec3 sky = mix(vec3(0.29, 0.49, 0.79), vec3(0.60, 0.75, 0.91), pow(1.0 - up, 3.0));
    sky = mix(sky, gl_Fog.color.rgb, pow(1.0 - up, 12.0)); // the horizon
    float sun = max(dot(way, sunDirection), 0.0);
    gl_FragColor = vec4(sky + pow(sun, 16.0) * vec3(0.18, 0.15, 0.10), 1.0);
})";

/// Covers the screen behind everything, and has no extent of its own.
osg::ref_ptr<osg::Geometry> createSky() {
    struct NoBounds : osg::Drawable::ComputeBoundingBoxCallback {
        osg::BoundingBox computeBound(const osg::Drawable&) const override { return {}; }
    };
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const osg::Vec3& corner :
         {osg::Vec3(-1, -1, 0), osg::Vec3(1, -1, 0), osg::Vec3(-1, 1, 0), osg::Vec3(1, 1, 0)})
        corners->push_back(corner);
    osg::ref_ptr<osg::Geometry> sky = new osg::Geometry;
    sky->setUseDisplayList(false);
    sky->setUseVertexBufferObjects(true);
    sky->setVertexArray(corners);
    sky->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 4));
    sky->setComputeBoundingBoxCallback(new NoBounds);
    sky->setCullingActive(false);
    osg::StateSet* state = sky->getOrCreateStateSet();
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX, skyVertex));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, skyFragment));
    state->setAttributeAndModes(program);
    state->addUniform(new osg::Uniform("sunDirection", sunDirection));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
    state->setRenderBinDetails(10, "RenderBin"); // after the opaque things: only what is still sky is shaded
    return sky;
}

osg::ref_ptr<osg::LightSource> createSun() {
    osg::ref_ptr<osg::LightSource> sun = new osg::LightSource;
    sun->getLight()->setPosition(osg::Vec4(sunDirection, 0.0f));
    sun->getLight()->setAmbient(osg::Vec4(0.34f, 0.39f, 0.47f, 1.0f));
    sun->getLight()->setDiffuse(osg::Vec4(1.50f, 1.40f, 1.18f, 1.0f));
    return sun;
}

/// A group whose forest casts the shadows of `sun`, on the forest too.
osg::ref_ptr<osg::Group> createShadowedGroup(osg::Light* sun) {
    osg::ref_ptr<osgShadow::ShadowMap> shadows = new osgShadow::ShadowMap;
    shadows->setLight(sun);
    shadows->setTextureUnit(shadowUnit);
    shadows->setTextureSize(osg::Vec2s(4096, 4096));
    shadows->setAmbientBias(osg::Vec2(0.35f, 0.65f)); // the sky's share of the light on level ground
    osg::ref_ptr<osgShadow::ShadowedScene> scene = new osgShadow::ShadowedScene(shadows);
    scene->setCastsShadowTraversalMask(castsShadow);
    return scene;
}

} // namespace

osg::ref_ptr<osg::Group> createSetting(Forest& forest, Shadows shadows) {
    osg::ref_ptr<osg::LightSource> sun = createSun();
    osg::ref_ptr<osg::Group> setting = shadows == Shadows::On ? createShadowedGroup(sun->getLight())
                                                              : osg::ref_ptr<osg::Group>(new osg::Group);
    // The picture is opaque, whatever is blended into it.
    osg::StateSet* state = setting->getOrCreateStateSet();
    state->setAttribute(new osg::ColorMask(true, true, true, false));
    osg::ref_ptr<osg::Fog> haze = new osg::Fog;
    haze->setMode(osg::Fog::EXP);
    haze->setColor(osg::Vec4(0.80f, 0.87f, 0.93f, 1.0f));
    haze->setDensity(1.6f / groundRadius(forest.getBound()));
    state->setAttributeAndModes(haze);

    const osg::ref_ptr<osg::Node> ground =
        forest.getGround() ? createRelief(forest) : osg::ref_ptr<osg::Node>(createGround(forest.getBound()));
    const osg::ref_ptr<osg::Geometry> sky = createSky();
    ground->getStateSet()->setRenderBinDetails(-2,
                                               "RenderBin"); // first, then the shadows over it, then all else
    ground->getStateSet()->setDefine("FOG_MODE", "2");
    if (shadows == Shadows::On) {
        ground->getStateSet()->setDefine("SHADOW_MAP", std::to_string(shadowUnit));
        ground->getStateSet()->setDefine("SHADOW_CLEARANCE", "0.0");
    }
    osg::ref_ptr<osg::Group> around = new osg::Group;
    around->setNodeMask(~castsShadow);
    around->addChild(ground);
    if (shadows == Shadows::Soft) {
        osg::ref_ptr<osg::Geometry> soft = createGroundShadows(forest, sunDirection);
        soft->getStateSet()->setRenderBinDetails(-1, "RenderBin");
        around->addChild(soft);
    }
    around->addChild(sky);
    setting->addChild(around);
    setting->addChild(sun);
    setting->addChild(&forest);
    return setting;
}
