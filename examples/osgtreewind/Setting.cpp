// SPDX-License-Identifier: MIT
#include "Setting.h"

#include <osg/ColorMask>
#include <osg/Depth>
#include <osg/Geometry>
#include <osg/LightSource>

#include <algorithm>
#include <cmath>

namespace {

using osgTreeWind::Forest;

const osg::Vec3 sunDirection(0.45f, -0.5f, 0.74f); // toward the sun, unit length to 1 %

const char* skyVertex = R"(#version 330 compatibility
out vec3 ray;
void main() {
    vec4 eye = gl_ProjectionMatrixInverse * vec4(gl_Vertex.xy, 1.0, 1.0);
    ray = mat3(gl_ModelViewMatrixInverse) * (eye.xyz / eye.w);
    gl_Position = vec4(gl_Vertex.xy, 1.0, 1.0);
})";

const char* skyFragment = R"(#version 330 compatibility
in vec3 ray;
uniform vec3 horizonColor;
void main() {
    float up = normalize(ray).z;
    vec3 zenith = vec3(0.30, 0.50, 0.80);
    gl_FragColor = vec4(mix(horizonColor, zenith, pow(clamp(up * 1.4, 0.0, 1.0), 0.6)), 1.0);
})";

const char* groundVertex = R"(#version 330 compatibility
out vec3 place;
out float distance_;
void main() {
    place = gl_Vertex.xyz;
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    distance_ = length(eye.xyz);
    gl_Position = gl_ProjectionMatrix * eye;
})";

const char* groundFragment = R"(#version 330 compatibility
in vec3 place;
in float distance_;
uniform vec3 horizonColor;
uniform float haze;
float hash(ivec2 p) {
    uint h = uint(p.x) * 0x9e3779b9u ^ uint(p.y) * 0x85ebca6bu;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    return float((h ^ (h >> 13)) & 0xffffu) / 65535.0;
}
float patches(vec2 p) {
    ivec2 i = ivec2(floor(p));
    vec2 f = smoothstep(0.0, 1.0, fract(p));
    return mix(mix(hash(i), hash(i + ivec2(1, 0)), f.x),
               mix(hash(i + ivec2(0, 1)), hash(i + ivec2(1, 1)), f.x), f.y);
}
void main() {
    float near = exp(-distance_ * 0.02);
    float tone = 0.5 * patches(place.xy * 0.05) + 0.3 * patches(place.xy * 0.4) +
                 0.2 * mix(0.5, patches(place.xy * 6.0), near);
    vec3 grass = mix(vec3(0.20, 0.27, 0.10), vec3(0.36, 0.42, 0.17), tone);
    gl_FragColor = vec4(mix(horizonColor, grass, exp(-distance_ * haze)), 1.0);
})";

const char* shadowVertex = R"(#version 330 compatibility
out vec2 spot;
void main() {
    spot = gl_MultiTexCoord0.xy;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
})";

const char* shadowFragment = R"(#version 330 compatibility
in vec2 spot;
void main() {
    float edge = 1.0 - dot(spot, spot);
    gl_FragColor = vec4(0.02, 0.04, 0.02, 0.6 * smoothstep(0.0, 0.7, edge));
})";

osg::ref_ptr<osg::Program> program(const char* vertex, const char* fragment) {
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX, vertex));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, fragment));
    return program;
}

osg::ref_ptr<osg::Geometry> geometry(osg::Vec3Array* vertices, GLenum mode) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(vertices);
    geometry->addPrimitiveSet(new osg::DrawArrays(mode, 0, static_cast<int>(vertices->size())));
    return geometry;
}

/// Covers the screen behind everything, and has no extent of its own.
osg::ref_ptr<osg::Geometry> createSky() {
    struct NoBounds : osg::Drawable::ComputeBoundingBoxCallback {
        osg::BoundingBox computeBound(const osg::Drawable&) const override { return {}; }
    };
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const osg::Vec3& corner :
         {osg::Vec3(-1, -1, 0), osg::Vec3(1, -1, 0), osg::Vec3(-1, 1, 0), osg::Vec3(1, 1, 0)})
        corners->push_back(corner);
    osg::ref_ptr<osg::Geometry> sky = geometry(corners, GL_TRIANGLE_STRIP);
    sky->setComputeBoundingBoxCallback(new NoBounds);
    sky->setCullingActive(false);
    osg::StateSet* state = sky->getOrCreateStateSet();
    state->setAttributeAndModes(program(skyVertex, skyFragment));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
    state->setRenderBinDetails(10, "RenderBin"); // after the opaque things: only what is still sky is shaded
    return sky;
}

osg::ref_ptr<osg::Geometry> createGround(const osg::BoundingSphere& bound) {
    osg::ref_ptr<osg::Vec3Array> rim = new osg::Vec3Array;
    const osg::Vec3 centre(bound.center().x(), bound.center().y(), 0.0f);
    const float radius = std::max(2000.0f, 8.0f * bound.radius());
    rim->push_back(centre);
    for (int i = 0; i <= 64; ++i) {
        const double angle = 2.0 * osg::PI * i / 64;
        rim->push_back(centre + osg::Vec3(static_cast<float>(std::cos(angle)),
                                          static_cast<float>(std::sin(angle)), 0.0f) *
                                    radius);
    }
    osg::ref_ptr<osg::Geometry> ground = geometry(rim, GL_TRIANGLE_FAN);
    osg::StateSet* state = ground->getOrCreateStateSet();
    state->setAttributeAndModes(program(groundVertex, groundFragment));
    state->addUniform(new osg::Uniform("haze", 1.6f / radius));
    state->setRenderBinDetails(-2, "RenderBin"); // first, then the shadows over it, then all else
    return ground;
}

/// A dark disc where the sun throws each crown, drawn over the ground.
osg::ref_ptr<osg::Geometry> createShadows(Forest& forest) {
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec2Array> spots = new osg::Vec2Array;
    const osg::Vec2 away(-sunDirection.x() / sunDirection.z(), -sunDirection.y() / sunDirection.z());
    for (unsigned i = 0; i < forest.getNumTrees(); ++i) {
        const osgTreeWind::PlacedTree& tree = forest.getSimulation().trees()[i];
        const osgTreeWind::TreeSize size =
            osgTreeWind::measureTree(forest.getSimulation().models()[tree.model], tree.scale);
        const osg::Vec3 foot(tree.position.x, tree.position.y, tree.position.z + 0.02f);
        const float radius = 0.55f * size.crownWidth, drop = 0.5f * size.height;
        const float stretch = 1.0f + 0.35f * size.height / std::max(size.crownWidth, 0.1f) * away.length();
        osg::Vec2 along = away;
        along.normalize();
        const osg::Vec2 across(-along.y(), along.x());
        for (const osg::Vec2& spot : {osg::Vec2(-1, -1), osg::Vec2(1, -1), osg::Vec2(1, 1), osg::Vec2(-1, -1),
                                      osg::Vec2(1, 1), osg::Vec2(-1, 1)}) {
            const osg::Vec2 offset =
                away * drop + along * (spot.x() * radius * stretch) + across * (spot.y() * radius);
            corners->push_back(foot + osg::Vec3(offset, 0.0f));
            spots->push_back(spot);
        }
    }
    osg::ref_ptr<osg::Geometry> shadows = geometry(corners, GL_TRIANGLES);
    shadows->setTexCoordArray(0, spots);
    osg::StateSet* state = shadows->getOrCreateStateSet();
    state->setAttributeAndModes(program(shadowVertex, shadowFragment));
    state->setMode(GL_BLEND, osg::StateAttribute::ON);
    state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false));
    state->setRenderBinDetails(-1, "RenderBin");
    return shadows;
}

osg::ref_ptr<osg::LightSource> createSun() {
    osg::ref_ptr<osg::LightSource> sun = new osg::LightSource;
    sun->getLight()->setPosition(osg::Vec4(sunDirection, 0.0f));
    sun->getLight()->setAmbient(osg::Vec4(0.32f, 0.37f, 0.45f, 1.0f));
    sun->getLight()->setDiffuse(osg::Vec4(1.25f, 1.18f, 1.02f, 1.0f));
    return sun;
}

} // namespace

osg::ref_ptr<osg::Group> createSetting(Forest& forest) {
    osg::ref_ptr<osg::Group> setting = new osg::Group;
    // The picture is opaque, whatever is blended into it.
    setting->getOrCreateStateSet()->setAttribute(new osg::ColorMask(true, true, true, false));
    setting->getOrCreateStateSet()->addUniform(
        new osg::Uniform("horizonColor", osg::Vec3(0.78f, 0.86f, 0.93f)));
    setting->addChild(createGround(forest.getBound()));
    setting->addChild(createShadows(forest));
    setting->addChild(createSky());
    setting->addChild(createSun());
    setting->addChild(&forest);
    return setting;
}
