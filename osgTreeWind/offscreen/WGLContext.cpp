// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>
#include <osgTreeWind/offscreen/OffscreenContextBase.h>

#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/wglext.h>

#include <memory>
#include <string>
#include <utility>

namespace osgTreeWind {
namespace {

template <typename Function>
Function wglFunction(const char* name) {
    return reinterpret_cast<Function>(reinterpret_cast<void (*)()>(wglGetProcAddress(name)));
}

/// A hidden window with a context, which Windows needs before it makes a pbuffer. It belongs to the thread
/// that creates it. Restores the current context at its end.
class HiddenWindow {
public:
    HiddenWindow() {
        static const bool registered = registerClass();
        if (registered)
            _window = CreateWindowW(className, L"", WS_POPUP, 0, 0, 1, 1, nullptr, nullptr,
                                    GetModuleHandleW(nullptr), nullptr);
        device = _window ? GetDC(_window) : nullptr;
        PIXELFORMATDESCRIPTOR format{};
        format.nSize = sizeof format;
        format.nVersion = 1;
        format.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL;
        format.cColorBits = 32;
        format.cDepthBits = 24;
        if (!device || !SetPixelFormat(device, ChoosePixelFormat(device, &format), &format))
            return;
        _context = wglCreateContext(device);
        if (!_context || !wglMakeCurrent(device, _context))
            return;
        chooseFormat = wglFunction<PFNWGLCHOOSEPIXELFORMATARBPROC>("wglChoosePixelFormatARB");
        createPbuffer = wglFunction<PFNWGLCREATEPBUFFERARBPROC>("wglCreatePbufferARB");
        getDevice = wglFunction<PFNWGLGETPBUFFERDCARBPROC>("wglGetPbufferDCARB");
        releaseDevice = wglFunction<PFNWGLRELEASEPBUFFERDCARBPROC>("wglReleasePbufferDCARB");
        destroyPbuffer = wglFunction<PFNWGLDESTROYPBUFFERARBPROC>("wglDestroyPbufferARB");
        createContext = wglFunction<PFNWGLCREATECONTEXTATTRIBSARBPROC>("wglCreateContextAttribsARB");
    }
    ~HiddenWindow() {
        if (_context) {
            wglMakeCurrent(_deviceBefore, _contextBefore);
            wglDeleteContext(_context);
        }
        if (_window) {
            ReleaseDC(_window, device);
            DestroyWindow(_window);
        }
    }
    HiddenWindow(const HiddenWindow&) = delete;
    HiddenWindow& operator=(const HiddenWindow&) = delete;

    /// Whether the driver has pbuffers and profiles.
    explicit operator bool() const {
        return chooseFormat && createPbuffer && getDevice && releaseDevice && destroyPbuffer && createContext;
    }

    HDC device = nullptr;
    PFNWGLCHOOSEPIXELFORMATARBPROC chooseFormat = nullptr;
    PFNWGLCREATEPBUFFERARBPROC createPbuffer = nullptr;
    PFNWGLGETPBUFFERDCARBPROC getDevice = nullptr;
    PFNWGLRELEASEPBUFFERDCARBPROC releaseDevice = nullptr;
    PFNWGLDESTROYPBUFFERARBPROC destroyPbuffer = nullptr;
    PFNWGLCREATECONTEXTATTRIBSARBPROC createContext = nullptr;

private:
    static constexpr const wchar_t* className = L"osgTreeWind offscreen";

    static bool registerClass() {
        WNDCLASSW form{};
        form.style = CS_OWNDC;
        form.lpfnWndProc = DefWindowProcW;
        form.hInstance = GetModuleHandleW(nullptr);
        form.lpszClassName = className;
        return RegisterClassW(&form) != 0 || GetLastError() == ERROR_CLASS_ALREADY_EXISTS; // by another DLL
    }

    const HDC _deviceBefore = wglGetCurrentDC();
    const HGLRC _contextBefore = wglGetCurrentContext();
    HWND _window = nullptr;
    HGLRC _context = nullptr;
};

/// A pbuffer and its device context.
class Pbuffer {
public:
    Pbuffer(const HiddenWindow& window, int format, int width, int height)
        : _releaseDevice(window.releaseDevice), _destroy(window.destroyPbuffer) {
        const int none[] = {0};
        _buffer = window.createPbuffer(window.device, format, width, height, none);
        device = _buffer ? window.getDevice(_buffer) : nullptr;
    }
    ~Pbuffer() {
        if (device)
            _releaseDevice(_buffer, device);
        if (_buffer)
            _destroy(_buffer);
    }
    Pbuffer(const Pbuffer&) = delete;
    Pbuffer& operator=(const Pbuffer&) = delete;

    HDC device = nullptr;

private:
    PFNWGLRELEASEPBUFFERDCARBPROC _releaseDevice;
    PFNWGLDESTROYPBUFFERARBPROC _destroy;
    HPBUFFERARB _buffer = nullptr;
};

class WGLGraphicsContext : public OffscreenContextBase {
public:
    WGLGraphicsContext(int width, int height, ContextProfile profile, std::unique_ptr<Pbuffer> pbuffer,
                       HGLRC context)
        : OffscreenContextBase(width, height, profile), _pbuffer(std::move(pbuffer)), _context(context) {
        _traits->doubleBuffer = true;
    }

    const char* className() const override { return "WGLGraphicsContext"; }
    bool valid() const override { return _context != nullptr; }
    bool makeCurrentImplementation() override {
        const auto lock = lockSoftwareRenderer();
        return valid() && wglMakeCurrent(_pbuffer->device, _context);
    }
    bool releaseContextImplementation() override {
        const auto lock = lockSoftwareRenderer();
        return wglMakeCurrent(nullptr, nullptr);
    }
    void closeImplementation() override {
        const auto lock = lockSoftwareRenderer();
        if (_context)
            wglDeleteContext(_context);
        _context = nullptr;
        _pbuffer.reset();
        _realized = false;
    }

protected:
    ~WGLGraphicsContext() override { close(); }

private:
    std::unique_ptr<Pbuffer> _pbuffer;
    HGLRC _context;
};

/// The pixel format of pbuffers; 0 if the driver has none.
int choosePbufferFormat(const HiddenWindow& window) {
    // Double buffered: Wine draws the front buffer of a pbuffer with Mesa's software renderer wrongly.
    const int attributes[] = {WGL_DRAW_TO_PBUFFER_ARB,
                              1,
                              WGL_SUPPORT_OPENGL_ARB,
                              1,
                              WGL_DOUBLE_BUFFER_ARB,
                              1,
                              WGL_PIXEL_TYPE_ARB,
                              WGL_TYPE_RGBA_ARB,
                              WGL_COLOR_BITS_ARB,
                              32,
                              WGL_ALPHA_BITS_ARB,
                              8,
                              WGL_DEPTH_BITS_ARB,
                              24,
                              WGL_STENCIL_BITS_ARB,
                              8,
                              0};
    int format = 0;
    UINT found = 0;
    return window.chooseFormat(window.device, attributes, nullptr, 1, &format, &found) && found > 0 ? format
                                                                                                    : 0;
}

} // namespace

const char* offscreenBackendName() {
    return "wgl";
}

Result<osg::ref_ptr<osg::GraphicsContext>> createOffscreenContext(int width, int height,
                                                                  ContextProfile profile) {
    if (const auto sizeError = OffscreenContextBase::sizeProblem(width, height))
        return *sizeError;

    const HiddenWindow window;
    const int format = window ? choosePbufferFormat(window) : 0;
    if (format == 0)
        return fileProblem({}, "OpenGL can draw only into windows; expected a graphics driver with "
                               "WGL_ARB_pbuffer, WGL_ARB_pixel_format and WGL_ARB_create_context_profile");
    auto pbuffer = std::make_unique<Pbuffer>(window, format, width, height);
    if (!pbuffer->device)
        return fileProblem({}, "OpenGL made no pbuffer of " + std::to_string(width) + "x" +
                                   std::to_string(height) + " pixels");

    const bool isCore = profile == ContextProfile::Core;
    const int attributes[] = {WGL_CONTEXT_PROFILE_MASK_ARB,
                              isCore ? WGL_CONTEXT_CORE_PROFILE_BIT_ARB
                                     : WGL_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB,
                              WGL_CONTEXT_MAJOR_VERSION_ARB,
                              isCore ? 3 : 1,
                              WGL_CONTEXT_MINOR_VERSION_ARB,
                              isCore ? 3 : 0,
                              0};
    const HGLRC context = window.createContext(pbuffer->device, nullptr, attributes);
    if (!context)
        return fileProblem({}, std::string("OpenGL made no context with the ") + profileName(profile) +
                                   " profile");
    return osg::ref_ptr<osg::GraphicsContext>(
        new WGLGraphicsContext(width, height, profile, std::move(pbuffer), context));
}

} // namespace osgTreeWind
