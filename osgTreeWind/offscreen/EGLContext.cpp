// SPDX-License-Identifier: MIT
#define EGL_NO_X11
#include <osgTreeWind/offscreen/OffscreenContext.h>
#include <osgTreeWind/offscreen/OffscreenContextBase.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>
#include <sstream>

namespace osgTreeWind {
namespace {

class EGLGraphicsContext : public OffscreenContextBase {
public:
    EGLGraphicsContext(int width, int height, ContextProfile profile, EGLDisplay display, EGLContext context,
                       EGLSurface surface)
        : OffscreenContextBase(width, height, profile), _display(display), _context(context),
          _surface(surface) {}

    const char* className() const override { return "EGLGraphicsContext"; }
    bool valid() const override { return _context != EGL_NO_CONTEXT; }
    bool makeCurrentImplementation() override {
        const auto lock = lockSoftwareRenderer();
        // The bound API is per thread, OpenGL ES by default, and determines what a release acts on.
        return valid() && eglBindAPI(EGL_OPENGL_API) &&
               eglMakeCurrent(_display, _surface, _surface, _context);
    }
    bool releaseContextImplementation() override {
        const auto lock = lockSoftwareRenderer();
        return eglMakeCurrent(_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    void closeImplementation() override {
        const auto lock = lockSoftwareRenderer();
        if (_context != EGL_NO_CONTEXT)
            eglDestroyContext(_display, _context);
        if (_surface != EGL_NO_SURFACE)
            eglDestroySurface(_display, _surface);
        _context = EGL_NO_CONTEXT;
        _surface = EGL_NO_SURFACE;
        _realized = false;
    }

protected:
    ~EGLGraphicsContext() override { close(); }

private:
    EGLDisplay _display;
    EGLContext _context;
    EGLSurface _surface;
};

Diagnostic problem(const std::string& message) {
    Diagnostic diagnostic;
    diagnostic.message = message;
    if (const EGLint error = eglGetError(); error != EGL_SUCCESS) {
        std::ostringstream code;
        code << " (EGL error 0x" << std::hex << error << ")";
        diagnostic.message += code.str();
    }
    return diagnostic;
}

/// Display and configuration, shared by all contexts and never terminated.
struct DisplayConfig {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLConfig config = nullptr;
    explicit operator bool() const { return display != EGL_NO_DISPLAY; }
};

/// Selects a configuration for OpenGL pbuffers; empty if the display has none.
DisplayConfig chooseConfig(EGLDisplay display) {
    const EGLint attributes[] = {EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_RED_SIZE,
                                 8,
                                 EGL_GREEN_SIZE,
                                 8,
                                 EGL_BLUE_SIZE,
                                 8,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_DEPTH_SIZE,
                                 24,
                                 EGL_STENCIL_SIZE,
                                 8,
                                 EGL_NONE};
    DisplayConfig chosen;
    EGLint found = 0;
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) &&
        eglChooseConfig(display, attributes, &chosen.config, 1, &found) && found == 1)
        chosen.display = display;
    return chosen;
}

/// The first usable GPU, else Mesa's surfaceless platform (a GPU of its choice, or software).
DisplayConfig findDisplayConfig() {
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto queryDeviceString =
        reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
    EGLDeviceEXT devices[32];
    EGLint count = 0;
    if (!queryDevices || !queryDeviceString || !queryDevices(32, devices, &count))
        count = 0;
    for (EGLint i = 0; i < count; ++i) {
        const char* const extensions = queryDeviceString(devices[i], EGL_EXTENSIONS);
        if (extensions && std::strstr(extensions, "EGL_MESA_device_software"))
            continue;
        if (const DisplayConfig gpu =
                chooseConfig(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr)))
            return gpu;
    }
    return chooseConfig(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
}

} // namespace

const char* offscreenBackendName() {
    return "egl";
}

Result<osg::ref_ptr<osg::GraphicsContext>> createOffscreenContext(int width, int height,
                                                                  ContextProfile profile) {
    if (const auto sizeError = OffscreenContextBase::sizeProblem(width, height))
        return *sizeError;

    static const DisplayConfig chosen = findDisplayConfig();
    if (!chosen)
        return problem("no EGL display supports OpenGL without a screen; expected a GPU driver with "
                       "EGL_EXT_platform_device, or Mesa with EGL_MESA_platform_surfaceless");
    if (!eglBindAPI(EGL_OPENGL_API))
        return problem("EGL offers no OpenGL, only OpenGL ES");

    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(chosen.display, chosen.config, size);
    if (surface == EGL_NO_SURFACE)
        return problem("EGL made no pbuffer of " + std::to_string(width) + "x" + std::to_string(height) +
                       " pixels");

    const bool isCore = profile == ContextProfile::Core;
    const EGLint attributes[] = {EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 isCore ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                                        : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                 EGL_CONTEXT_MAJOR_VERSION,
                                 isCore ? 3 : 1,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 isCore ? 3 : 0,
                                 EGL_NONE};
    const EGLContext context = eglCreateContext(chosen.display, chosen.config, EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT) {
        Diagnostic missing =
            problem(std::string("EGL made no context with the OpenGL ") + profileName(profile) + " profile");
        eglDestroySurface(chosen.display, surface);
        return missing;
    }
    return osg::ref_ptr<osg::GraphicsContext>(
        new EGLGraphicsContext(width, height, profile, chosen.display, context, surface));
}

} // namespace osgTreeWind
