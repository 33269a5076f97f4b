// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/Sky.h>

#include <osg/ColorMask>
#include <osg/Depth>
#include <osg/Program>

#include <string>

namespace {

const char* skyVertexText = R"(#version 330 compatibility
out vec3 ray;
void main() {
    vec4 eye = gl_ProjectionMatrixInverse * vec4(gl_Vertex.xy, 1.0, 1.0);
    ray = mat3(gl_ModelViewMatrixInverse) * (eye.xyz / eye.w);
    gl_Position = vec4(gl_Vertex.xy, 1.0, 1.0);
})";

const char* skyFragmentText = R"(
in vec3 ray;
uniform vec3 skyZenith, skyHorizon;
void main() {
    vec3 way = normalize(ray);
    float up = clamp(way.z, 0.0, 1.0);
    vec3 sky = mix(skyZenith, skyHorizon, pow(1.0 - up, 3.0));
    sky = mix(sky, gl_Fog.color.rgb, pow(1.0 - up, 12.0)); // the haze
    gl_FragColor = vec4(sky + glow(way), 1.0);
})";

} // namespace

const char* const glowText = R"(
uniform vec3 sunDirection, sunGlow;
vec3 glow(vec3 way) { return pow(max(dot(way, sunDirection), 0.0), 16.0) * sunGlow; }
)";

void setSkyUniforms(osg::StateSet& state, const Daylight& day) {
    state.addUniform(new osg::Uniform("sunDirection", day.toSun));
    state.addUniform(new osg::Uniform("sunGlow", day.glow));
    state.addUniform(new osg::Uniform("skyZenith", day.zenith));
    state.addUniform(new osg::Uniform("skyHorizon", day.horizon));
}

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
    program->addShader(new osg::Shader(osg::Shader::VERTEX, skyVertexText));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, std::string("#version 330 compatibility\n") +
                                                                  glowText + skyFragmentText));
    state->setAttributeAndModes(program);
    state->setAttribute(new osg::ColorMask(true, true, true, true)); // over what shadows left in alpha
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
    state->setRenderBinDetails(10, "RenderBin"); // only what is still sky is shaded
    return sky;
}
