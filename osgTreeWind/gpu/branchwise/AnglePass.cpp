// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/branchwise/AnglePass.h>

#include <osgTreeWind/gpu/DistinctArrays.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/ColorMask>
#include <osg/Geometry>
#include <osg/PolygonMode>

#include <mutex>

namespace osgTreeWind {
namespace {

constexpr auto forced = osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED;

/// Disables all state of the scene that could change the computed values.
void computeOnly(osg::StateSet& state) {
    for (const GLenum mode : {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_ALPHA_TEST, GL_SCISSOR_TEST,
                              GL_STENCIL_TEST, GL_LIGHTING, GL_FRAMEBUFFER_SRGB})
        state.setMode(mode, osg::StateAttribute::OFF | forced);
    state.setAttribute(new osg::ColorMask(true, true, true, true), forced);
    state.setAttribute(new osg::PolygonMode, forced);
}

osg::ref_ptr<osg::Camera> createCamera(osg::Texture2D* target) {
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setName(target->getName());
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->setImplicitBufferAttachmentMask(0, 0);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setViewport(0, 0, target->getImage()->s(), target->getImage()->t());
    camera->setClearMask(0);
    camera->setCullingActive(false);
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setAllowEventFocus(false);
    camera->setDataVariance(osg::Object::DYNAMIC);
    camera->attach(osg::Camera::COLOR_BUFFER0, target);
    camera->setNodeMask(0);
    return camera;
}

} // namespace

/// Draws all texels of the target, and copies them to the texture of the states and to the CPU. DYNAMIC, so
/// that the next update waits for the draw.
class AnglePass::Quad : public osg::Geometry {
public:
    explicit Quad(osg::Texture2D* states) : _states(states) {
        osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
        for (const osg::Vec3& corner :
             {osg::Vec3(-1, -1, 0), osg::Vec3(1, -1, 0), osg::Vec3(-1, 1, 0), osg::Vec3(1, 1, 0)})
            corners->push_back(corner);
        setUseDisplayList(false);
        setUseVertexBufferObjects(true);
        setVertexArray(corners);
        makeArraysDistinct(*this);
        addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 4));
        setCullingActive(false);
        setDataVariance(osg::Object::DYNAMIC);
    }

    void drawImplementation(osg::RenderInfo& renderInfo) const override {
        _guard.run("branches may stand still", [&] {
            osg::Geometry::drawImplementation(renderInfo);
            osg::State& state = *renderInfo.getState();
            state.setActiveTextureUnit(0);
            state.applyTextureAttribute(0, _states);
            const osg::Image& size = *_states->getImage();
            glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, size.s(), size.t());
            read(state, static_cast<std::size_t>(size.s()) * static_cast<std::size_t>(size.t()));
        });
    }

    bool readBack(std::vector<glm::vec4>& texels) {
        const std::lock_guard<std::mutex> lock(_mutex);
        if (!_fresh)
            return false;
        texels.swap(_texels);
        _fresh = false;
        return true;
    }

private:
    void read(const osg::State& state, std::size_t count) const {
        const std::lock_guard<std::mutex> lock(_mutex);
        const unsigned frame = state.getFrameStamp() ? state.getFrameStamp()->getFrameNumber() : 0;
        if (_fresh && frame <= _frame)
            return; // another context drew this frame before
        _texels.resize(count);
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        glPixelStorei(GL_PACK_ROW_LENGTH, 0);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, _texels.data());
        _frame = frame;
        _fresh = true;
    }

    ExceptionGuard _guard;
    osg::ref_ptr<osg::Texture2D> _states;
    mutable std::mutex _mutex; ///< Guards the members below.
    mutable std::vector<glm::vec4> _texels;
    mutable unsigned _frame = 0;
    mutable bool _fresh = false;
};

AnglePass::AnglePass(const char* shader, const std::vector<glm::vec4>& states)
    : _states(shader, states.size()), _target(shader, states.size()), _quad(new Quad(_states.texture())),
      _camera(createCamera(_target.texture())) {
    _states.write(states);
    _camera->addChild(_quad);
    osg::StateSet& state = *_camera->getOrCreateStateSet();
    state.setDataVariance(osg::Object::DYNAMIC);
    computeOnly(state);
    state.setTextureAttribute(0, _states.texture(), forced);
    state.setAttributeAndModes(sharedProgram("texels", shader), osg::StateAttribute::ON | forced);
    state.addUniform(new osg::Uniform("previousAngles", 0));
}

AnglePass::~AnglePass() = default;

bool AnglePass::readBack(std::vector<glm::vec4>& texels) {
    if (!_quad->readBack(texels))
        return false;
    _states.write(texels); // not dirty: existing contexts continue from their own states
    return true;
}

} // namespace osgTreeWind
