// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>
#include <osgTreeWind/offscreen/OffscreenContextBase.h>

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <cstdint>
#include <memory>
#include <new>

namespace osgTreeWind {
namespace {

class OSMesaGraphicsContext : public OffscreenContextBase {
public:
    OSMesaGraphicsContext(int width, int height, ContextProfile profile, OSMesaContext context,
                          std::unique_ptr<std::uint32_t[]> pixels)
        : OffscreenContextBase(width, height, profile), _context(context), _pixels(std::move(pixels)) {}

    const char* className() const override { return "OSMesaGraphicsContext"; }
    bool valid() const override { return _context != nullptr; }
    bool makeCurrentImplementation() override {
        const auto lock = lockSoftwareRenderer();
        return valid() &&
               OSMesaMakeCurrent(_context, _pixels.get(), GL_UNSIGNED_BYTE, _traits->width, _traits->height);
    }
    bool releaseContextImplementation() override {
        const auto lock = lockSoftwareRenderer();
        return OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    }
    void closeImplementation() override {
        const auto lock = lockSoftwareRenderer();
        if (_context)
            OSMesaDestroyContext(_context);
        _context = nullptr;
        _pixels.reset();
        _realized = false;
    }

protected:
    ~OSMesaGraphicsContext() override { close(); }

private:
    OSMesaContext _context;
    std::unique_ptr<std::uint32_t[]> _pixels; ///< Colour buffer of Mesa, RGBA8.
};

/// Path of the library that defines a global symbol; empty if there is none.
std::string findDefiningLibrary(const char* symbol) {
    Dl_info info{};
    void* const address = dlsym(RTLD_DEFAULT, symbol);
    return address && dladdr(address, &info) ? info.dli_fname : std::string();
}

} // namespace

const char* offscreenBackendName() {
    return "osmesa";
}

Result<osg::ref_ptr<osg::GraphicsContext>> createOffscreenContext(int width, int height,
                                                                  ContextProfile profile) {
    if (const auto sizeError = OffscreenContextBase::sizeProblem(width, height))
        return *sizeError;

    // OSG finds OpenGL by global symbols. If libGL comes before libOSMesa, the first call crashes.
    const std::string library = findDefiningLibrary("glGetString");
    if (library != findDefiningLibrary("OSMesaMakeCurrent"))
        return fileProblem(
            {}, "OpenGL comes from " + library +
                    " and not from libOSMesa; expected a program that links osgTreeWind::OSMesa directly and "
                    "does not link OpenGL::GL");

    std::unique_ptr<std::uint32_t[]> pixels(new (std::nothrow) std::uint32_t[std::size_t(width) * height]);
    if (!pixels)
        return fileProblem({}, "out of memory for the pixels of an offscreen context");

    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_PROFILE,
                              profile == ContextProfile::Core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              profile == ContextProfile::Core ? 3 : 1,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              profile == ContextProfile::Core ? 3 : 0,
                              0};
    const OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context)
        return fileProblem({}, std::string("libOSMesa made no context; expected an OpenGL ") +
                                   profileName(profile) + " profile");

    return osg::ref_ptr<osg::GraphicsContext>(
        new OSMesaGraphicsContext(width, height, profile, context, std::move(pixels)));
}

} // namespace osgTreeWind
