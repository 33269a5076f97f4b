// SPDX-License-Identifier: MIT
#include <osgTreeWind/offscreen/OffscreenContextBase.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/gpu/OpenGLProfile.h>

#include <osg/GLExtensions>
#include <osg/Notify>

#include <cstring>

namespace osgTreeWind {

std::optional<Diagnostic> OffscreenContextBase::sizeProblem(int width, int height) {
    const auto isGood = [](int size) { return size >= 1 && size <= maxOffscreenSize; };
    if (isGood(width) && isGood(height))
        return std::nullopt;
    return keyProblem("size", "an offscreen context of " + std::to_string(width) + "x" +
                                  std::to_string(height) +
                                  " pixels cannot be made; expected width and height from 1 to " +
                                  std::to_string(maxOffscreenSize));
}

OffscreenContextBase::OffscreenContextBase(int width, int height, ContextProfile profile) {
    _traits = new Traits;
    _traits->width = width;
    _traits->height = height;
    _traits->red = _traits->green = _traits->blue = _traits->alpha = 8;
    _traits->depth = 24;
    _traits->stencil = 8;
    _traits->pbuffer = true;
    _traits->doubleBuffer = false;

    setState(new osg::State);
    getState()->setGraphicsContext(this);
    getState()->setContextID(createNewContextID());
    if (profile != ContextProfile::Core)
        return;
    _traits->glContextVersion = "3.3";
    _traits->glContextProfileMask = 1;
    osg::ref_ptr<osg::DisplaySettings> settings = new osg::DisplaySettings(*osg::DisplaySettings::instance());
    settings->setVertexBufferHint(osg::DisplaySettings::VERTEX_ARRAY_OBJECT);
    getState()->setDisplaySettings(settings);
    useCoreState(*getState());
}

std::unique_lock<std::recursive_mutex> OffscreenContextBase::lockSoftwareRenderer() const {
    static std::recursive_mutex mutex;
    return _isSoftwareRenderer ? std::unique_lock(mutex) : std::unique_lock<std::recursive_mutex>();
}

void OffscreenContextBase::runOperations() {
    const auto lock = lockSoftwareRenderer();
    osg::GraphicsContext::runOperations();
}

bool OffscreenContextBase::realizeImplementation() {
    const auto lock = lockSoftwareRenderer();
    if (!valid() || !makeCurrentImplementation())
        return false;
    const auto* const renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    _isSoftwareRenderer =
        renderer && (std::strstr(renderer, "llvmpipe") || std::strstr(renderer, "softpipe"));
    // Mesa and libglvnd have entry points for all extensions. OSG takes this one for support, and
    // multisampled frame buffer objects then fail.
    const unsigned int id = getState()->getContextID();
    if (getState()->getUseVertexAttributeAliasing())
        useCoreExtensions(*osg::GLExtensions::Get(id, true));
    if (!osg::isGLExtensionSupported(id, "GL_NV_framebuffer_multisample_coverage"))
        osg::GLExtensions::Get(id, true)->glRenderbufferStorageMultisampleCoverageNV = nullptr;
    _realized = releaseContextImplementation();
    return _realized;
}

bool OffscreenContextBase::makeContextCurrentImplementation(osg::GraphicsContext* readContext) {
    return readContext == this && makeCurrentImplementation();
}

void OffscreenContextBase::bindPBufferToTextureImplementation(GLenum) {
    OSG_WARN << "osgTreeWind: an offscreen context cannot be bound as a texture; render to a texture instead"
             << std::endl;
}

} // namespace osgTreeWind
