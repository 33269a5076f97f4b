// SPDX-License-Identifier: MIT
// Lets OSG programs such as osgviewer run without a display:
//   LD_PRELOAD=libosgTreeWindHeadless.so OSG_RUN_FRAME_COUNT=10 osgviewer scene.osgt
// Their windows become offscreen contexts. The only event is the request to quit after OSG_RUN_FRAME_COUNT
// frames, for programs with their own frame loop, which does not use this variable.
#include <osgTreeWind/gpu/ExceptionGuard.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osg/Notify>
#include <osg/os_utils>
#include <osgViewer/GraphicsWindow>

namespace osgTreeWind {
namespace {

/// An osgViewer::GraphicsWindow around a realized offscreen context. It takes over the context's osg::State.
class HeadlessWindow : public osgViewer::GraphicsWindow {
public:
    explicit HeadlessWindow(osg::GraphicsContext* offscreen) : _context(offscreen) {
        _traits = new Traits(*offscreen->getTraits());
        setState(offscreen->getState());
        getState()->setGraphicsContext(this);
        offscreen->setState(nullptr);
        osg::getEnvVar("OSG_RUN_FRAME_COUNT", _lastFrame);
    }
    bool checkEvents() override {
        if (++_frame > _lastFrame)
            getEventQueue()->quitApplication();
        return _frame > _lastFrame;
    }
    bool valid() const override { return _context->valid(); }
    bool realizeImplementation() override { return _context->isRealized(); }
    bool isRealizedImplementation() const override { return _context->isRealized(); }
    bool makeCurrentImplementation() override { return _context->makeCurrentImplementation(); }
    bool releaseContextImplementation() override { return _context->releaseContextImplementation(); }
    void closeImplementation() override { _context->close(); }
    void swapBuffersImplementation() override {}
    void grabFocus() override {}
    void grabFocusIfPointerInWindow() override {}

protected:
    ~HeadlessWindow() override { close(); }

private:
    osg::ref_ptr<osg::GraphicsContext> _context;
    unsigned _frame = 0, _lastFrame = ~0u;
};

class HeadlessWindowingSystem : public osg::GraphicsContext::WindowingSystemInterface {
public:
    using ScreenIdentifier = osg::GraphicsContext::ScreenIdentifier;
    using ScreenSettings = osg::GraphicsContext::ScreenSettings;

    unsigned int getNumScreens(const ScreenIdentifier&) override { return 1; }
    void getScreenSettings(const ScreenIdentifier&, ScreenSettings& settings) override {
        settings = ScreenSettings(1280, 720, 60, 32);
    }
    void enumerateScreenSettings(const ScreenIdentifier& screen,
                                 osg::GraphicsContext::ScreenSettingsList& list) override {
        list.resize(1);
        getScreenSettings(screen, list.front());
    }
    osg::GraphicsContext* createGraphicsContext(osg::GraphicsContext::Traits* traits) override {
        osg::GraphicsContext* context = nullptr;
        ExceptionGuard().run("there is no window", [&] { context = make(traits); });
        return context;
    }

private:
    static osg::GraphicsContext* make(osg::GraphicsContext::Traits* traits) {
        auto made =
            createOffscreenContext(traits->width, traits->height,
                                   traits->glContextProfileMask & 1 ? ContextProfile::Core : osgProfile);
        if (!made) {
            OSG_WARN << "osgTreeWindHeadless: " << made.problems().front().message << std::endl;
            return nullptr;
        }
        if (!made.value()->realize())
            return nullptr;
        traits->doubleBuffer = false; // OSG selects the camera's draw buffer by its own traits
        return new HeadlessWindow(made.value());
    }
};

[[maybe_unused]] const bool inserted = [] {
    // First in the list, before X11, even if the library with X11 is initialized later.
    auto& systems = osg::GraphicsContext::getWindowingSystemInterfaces()->getInterfaces();
    systems.insert(systems.begin(), new HeadlessWindowingSystem);
    return true;
}();

} // namespace
} // namespace osgTreeWind
