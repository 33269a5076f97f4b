// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/branchwise/AnglePass.h>

#include <osgTreeWind/gpu/DistinctArrays.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/ColorMask>
#include <osg/Geometry>
#include <osg/PolygonMode>

namespace osgTreeWind {
namespace {

constexpr auto firmly = osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED;

osg::ref_ptr<osg::Geometry> createQuad() {
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const osg::Vec3& corner :
         {osg::Vec3(-1, -1, 0), osg::Vec3(1, -1, 0), osg::Vec3(-1, 1, 0), osg::Vec3(1, 1, 0)})
        corners->push_back(corner);
    osg::ref_ptr<osg::Geometry> quad = new osg::Geometry;
    quad->setUseDisplayList(false);
    quad->setUseVertexBufferObjects(true);
    quad->setVertexArray(corners);
    makeArraysDistinct(*quad);
    quad->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 4));
    quad->setCullingActive(false);
    quad->setDataVariance(osg::Object::DYNAMIC); // its inputs change every frame
    return quad;
}

/// Nothing that a scene may set above it gets between a fragment and its texel.
void computeOnly(osg::StateSet& state) {
    for (const GLenum mode : {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_ALPHA_TEST, GL_SCISSOR_TEST,
                              GL_STENCIL_TEST, GL_LIGHTING, GL_FRAMEBUFFER_SRGB})
        state.setMode(mode, osg::StateAttribute::OFF | firmly);
    state.setAttribute(new osg::ColorMask(true, true, true, true), firmly);
    state.setAttribute(new osg::PolygonMode, firmly);
}

osg::ref_ptr<osg::Camera> createCamera(osg::Texture2D* from, osg::Texture2D* to) {
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setName(to->getName());
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->setImplicitBufferAttachmentMask(0, 0);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setViewport(0, 0, to->getImage()->s(), to->getImage()->t());
    camera->setClearMask(0);
    camera->setCullingActive(false);
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setAllowEventFocus(false);
    camera->setDataVariance(osg::Object::DYNAMIC);
    camera->attach(osg::Camera::COLOR_BUFFER0, to);
    camera->getOrCreateStateSet()->setTextureAttribute(0, from, firmly);
    camera->addChild(createQuad());
    camera->setNodeMask(0);
    return camera;
}

} // namespace

AnglePass::AnglePass(const char* shader, const std::vector<glm::vec4>& states)
    : _node(new osg::Group), _textures{{shader, states.size()}, {shader, states.size()}} {
    startFrom(states);
    for (int i = 0; i < 2; ++i) {
        _cameras[i] = createCamera(_textures[1 - i].texture(), _textures[i].texture());
        _node->addChild(_cameras[i]);
    }
    _node->setDataVariance(osg::Object::DYNAMIC);
    osg::StateSet& state = *_node->getOrCreateStateSet();
    state.setDataVariance(osg::Object::DYNAMIC);
    computeOnly(state);
    state.setAttributeAndModes(createProgram("texels", shader), osg::StateAttribute::ON | firmly);
    state.addUniform(new osg::Uniform("previousAngles", 0));
}

void AnglePass::step() {
    _latest = 1 - _latest;
    _cameras[_latest]->setNodeMask(~0u);
    _cameras[1 - _latest]->setNodeMask(0);
}

void AnglePass::hold() {
    for (const osg::ref_ptr<osg::Camera>& camera : _cameras)
        camera->setNodeMask(0);
}

void AnglePass::startFrom(const std::vector<glm::vec4>& texels) {
    for (const DataTexture& texture : _textures) // not dirty: contexts that have them go on from their own
        texture.write(texels);
}

void AnglePass::setPostDrawCallback(osg::Camera::DrawCallback* callback) {
    for (const osg::ref_ptr<osg::Camera>& camera : _cameras)
        camera->setPostDrawCallback(callback);
}

} // namespace osgTreeWind
