// SPDX-License-Identifier: MIT
// Lets a stock OSG program, osgviewer for one, run without a display:
//   LD_PRELOAD=libosgTreeWindHeadless.so:libOSMesa.so.8 OSG_RUN_FRAME_COUNT=10 osgviewer scene.osgt
// The windows it asks for become offscreen contexts that nobody sees. They send no events but one: to quit,
// after OSG_RUN_FRAME_COUNT frames, to programs with a frame loop of their own, where OSG does not look at
// it.
#include <osgTreeWind/gpu/EntryGuard.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osg/Notify>
#include <osg/os_utils>
#include <osgViewer/GraphicsWindow>

namespace osgTreeWind {
namespace {

/// The window that osgViewer insists on, around a realized offscreen context whose state it takes over.
class HeadlessWindow : public osgViewer::GraphicsWindow {
public:
    explicit HeadlessWindow(osg::GraphicsContext* pixels) : _pixels(pixels) {
        _traits = new Traits(*pixels->getTraits());
        setState(pixels->getState());
        getState()->setGraphicsContext(this);
        pixels->setState(nullptr);
        osg::getEnvVar("OSG_RUN_FRAME_COUNT", _lastFrame);
    }
    bool checkEvents() override {
        if (++_frame > _lastFrame)
            getEventQueue()->quitApplication();
        return _frame > _lastFrame;
    }
    bool valid() const override { return _pixels->valid(); }
    bool realizeImplementation() override { return _pixels->isRealized(); }
    bool isRealizedImplementation() const override { return _pixels->isRealized(); }
    bool makeCurrentImplementation() override { return _pixels->makeCurrentImplementation(); }
    bool releaseContextImplementation() override { return _pixels->releaseContextImplementation(); }
    void closeImplementation() override { _pixels->close(); }
    void swapBuffersImplementation() override {}
    void grabFocus() override {}
    void grabFocusIfPointerInWindow() override {}

protected:
    ~HeadlessWindow() override { close(); }

private:
    osg::ref_ptr<osg::GraphicsContext> _pixels;
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
        EntryGuard().run("there is no window", [&] { context = make(traits); });
        return context;
    }

private:
    static osg::GraphicsContext* make(osg::GraphicsContext::Traits* traits) {
        auto made = createOffscreenContext(traits->width, traits->height);
        if (!made) {
            OSG_WARN << "osgTreeWindHeadless: " << made.problems().front().message
                     << " (preload libosgTreeWindHeadless.so:libOSMesa.so.8, in this order)" << std::endl;
            return nullptr;
        }
        if (!made.value()->realize())
            return nullptr;
        traits->doubleBuffer = false; // OSG picks the camera's draw buffer by what it asked for
        return new HeadlessWindow(made.value());
    }
};

[[maybe_unused]] const bool inserted = [] {
    // In front of X11, and there even when the library with X11 is initialized later.
    auto& systems = osg::GraphicsContext::getWindowingSystemInterfaces()->getInterfaces();
    systems.insert(systems.begin(), new HeadlessWindowingSystem);
    return true;
}();

} // namespace
} // namespace osgTreeWind
