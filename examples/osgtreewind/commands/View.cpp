// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/options/LightOptions.h>
#include <examples/osgtreewind/options/Offscreen.h>
#include <examples/osgtreewind/pictures/ClipRecorder.h>
#include <examples/osgtreewind/scene/DefaultView.h>
#include <examples/osgtreewind/scene/FeetGround.h>
#include <examples/osgtreewind/scene/Setting.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/controls/ForestHandler.h>
#include <osgTreeWind/controls/StatisticsLines.h>
#include <osgTreeWind/drawing/BranchTransform.h>
#include <osgTreeWind/forest/ForestTiles.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>
#include <osgTreeWind/system/Path.h>

#include <osg/DisplaySettings>
#include <osg/Quat>
#include <osg/os_utils>
#include <osgGA/FirstPersonManipulator>
#include <osgGA/FlightManipulator>
#include <osgGA/KeySwitchMatrixManipulator>
#include <osgGA/NodeTrackerManipulator>
#include <osgGA/TerrainManipulator>
#include <osgViewer/Viewer>
#include <osgViewer/ViewerEventHandlers>

#include <filesystem>
#include <iostream>
#include <memory>

namespace {

using namespace osgTreeWind;

struct ViewOptions {
    std::string file, size = "1280x720", save;
    int frames = 0, width = 0, height = 0;
    std::optional<float> season;
    LightOptions light;
};

/// The forest with its surroundings and the overlay of its handler.
class ViewScene {
public:
    ViewScene(Forest* forest, ForestHandler* handler, const ForestView& view, const ViewOptions& options)
        : _forest(forest), _root(new osg::Group), _view(view), _light(options.light) {
        _root->addChild(handler->getOverlay());
        light();
    }
    osg::Group* root() const { return _root.get(); }

    /// Moves the sun on by some hours, unless it would set.
    void moveSun(double hours) {
        constexpr double latitude = 50.0; // of central Europe: the place of the forest is unknown
        constexpr double degreesPerHour = 15.0;
        const osg::Vec3d pole(0.0, math::cos(osg::DegreesToRadians(latitude)),
                              math::sin(osg::DegreesToRadians(latitude)));
        const osg::Vec3 sun = osg::Quat(-osg::DegreesToRadians(degreesPerHour * hours), pole) * _light.toSun;
        if (sun.z() < 0.05f)
            return;
        _light.toSun = sun;
        light();
    }

private:
    void light() {
        _root->removeChild(_setting);
        _setting = createSetting(*_forest, {_light.shadows, _light.day(), _view.eye});
        _root->insertChild(0, _setting);
    }

    osg::ref_ptr<Forest> _forest;
    osg::ref_ptr<osg::Group> _root, _setting;
    ForestView _view;
    LightOptions _light;
};

/// The keys of this program, in addition to those of ForestHandler.
class ViewKeys : public osgGA::GUIEventHandler {
public:
    ViewKeys(ViewScene& scene, Forest* forest, ForestHandler* handler,
             osgGA::KeySwitchMatrixManipulator* manipulators, std::string file, std::string save,
             ClipRecorder* recorder)
        : _scene(scene), _forest(forest), _handler(handler), _manipulators(manipulators),
          _file(std::move(file)), _save(std::move(save)), _recorder(recorder) {}

    using osgGA::GUIEventHandler::handle;
    bool handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter&) override {
        if (event.getHandled() || event.getEventType() != osgGA::GUIEventAdapter::KEYDOWN)
            return false;
        switch (event.getKey()) {
        case 'k':
            _scene.moveSun(0.5);
            return true;
        case 'K':
            _scene.moveSun(-0.5);
            return true;
        case 'w':
            write();
            return true;
        case 'C':
            std::cout << _recorder->toggle() << std::endl;
            return true;
        case 'x':
            follow();
            return true;
        default:
            return false;
        }
    }
    void getUsage(osg::ApplicationUsage& usage) const override {
        usage.addKeyboardMouseBinding("View: k, K", "move the sun half an hour later, earlier");
        usage.addKeyboardMouseBinding("View: w", "save the forest as it is to " + _save);
        usage.addKeyboardMouseBinding("View: C", "start or stop recording a video");
        usage.addKeyboardMouseBinding("View: x", "follow the branch that was clicked");
    }

private:
    void write() {
        const Diagnostics problems =
            editForestFile(_forest->getSimulation().currentDescription(), _file, _save);
        if (problems.empty())
            std::cout << "wrote " << _save << std::endl;
        else
            std::cerr << toString(problems) << std::endl;
    }

    void follow() {
        const std::optional<TreeId> tree = _handler->getTree();
        if (!tree)
            return;
        const Result<BranchTransform*> branch = _forest->branch(*tree, _handler->getUnit());
        if (!branch)
            return;
        osg::ref_ptr<osgGA::NodeTrackerManipulator> tracker = new osgGA::NodeTrackerManipulator;
        tracker->setTrackNode(branch.value());
        tracker->setTrackerMode(osgGA::NodeTrackerManipulator::NODE_CENTER);
        tracker->setDistance(6.0);
        _manipulators->addMatrixManipulator('4', "Branch", tracker);
        _manipulators->selectMatrixManipulator(_manipulators->getNumMatrixManipulators() - 1);
    }

    ViewScene& _scene;
    osg::ref_ptr<Forest> _forest;
    osg::ref_ptr<ForestHandler> _handler;
    osg::ref_ptr<osgGA::KeySwitchMatrixManipulator> _manipulators;
    std::string _file, _save;
    osg::ref_ptr<ClipRecorder> _recorder;
};

/// View of the middle of a world, or of a forest at eye level.
ForestView initialView(const Forest& forest, const Lens& lens, const osg::Vec3& sun) {
    constexpr double aboveGround = 40.0, ahead = 300.0; // metres
    if (!forest.getDescription().tiles)
        return viewAtEyeLevel(forest, lens, sun);
    const osg::Vec3d centre = forest.getBound().center();
    const osg::Vec3d eye(centre.x(), centre.y(),
                         groundHeight(forest, {centre.x(), centre.y()}, centre.z()) + aboveGround);
    return {eye, eye + osg::Vec3d(0.0, ahead, -0.5 * aboveGround)};
}

osg::ref_ptr<osgGA::KeySwitchMatrixManipulator> createManipulators(const ForestView& view) {
    osg::ref_ptr<osgGA::KeySwitchMatrixManipulator> manipulators = new osgGA::KeySwitchMatrixManipulator;
    manipulators->addMatrixManipulator('1', "Around", new osgGA::TerrainManipulator);
    manipulators->addMatrixManipulator('2', "Walk", new osgGA::FirstPersonManipulator);
    manipulators->addMatrixManipulator('3', "Fly", new osgGA::FlightManipulator);
    manipulators->setHomePosition(view.eye, view.center, osg::Z_AXIS);
    return manipulators;
}

const CommandError noWindow = {
    Failed, "view: cannot open a window; osgtreewind render draws pictures without a display"};

/// Opens a window with 4 samples per pixel, or OSG_MULTI_SAMPLES. Where the display has no such windows,
/// opens one with less, and says so.
void openWindow(osgViewer::Viewer& viewer, int width, int height) {
    int samples = 4;
    osg::getEnvVar("OSG_MULTI_SAMPLES", samples);
    const int wanted = samples = std::max(samples, 0);
    const auto open = [&] {
        osg::DisplaySettings::instance()->setNumMultiSamples(samples);
        viewer.setUpViewInWindow(60, 60, width, height);
        return viewer.getCamera()->getGraphicsContext() != nullptr;
    };
    const osg::NotifySeverity severity = osg::getNotifyLevel();
    osg::setNotifyLevel(osg::ALWAYS); // OSG reports each window that cannot be opened
    bool isOpen = open();
    while (!isOpen && samples > 0) {
        samples /= 2;
        isOpen = open();
    }
    osg::setNotifyLevel(severity);
    if (!isOpen)
        throw noWindow;
    if (samples < wanted)
        std::cerr << "view: this display has no windows with " << wanted
                  << " samples per pixel; the window has " << (samples > 0 ? std::to_string(samples) : "one")
                  << std::endl;
}

void show(const ViewOptions& options) {
    if (offscreenBackendName() == std::string("osmesa"))
        runOtherBackend("egl"); // a window needs the OpenGL of the system
    ForestFile description = valueOrThrow(readForestFile(options.file));
    printNotes(options.file, description.notes);
    description.season = options.season.value_or(description.season);
    if (!description.ground && !description.tiles)
        description.ground = groundThroughFeet(description);
    const osg::ref_ptr<Forest> forest =
        valueOrThrow(Forest::create(std::move(description)), BadInput, options.file);
    const Lens lens{40.0, static_cast<double>(options.width) / options.height};
    const ForestView view = initialView(*forest, lens, options.light.toSun);
    osg::ref_ptr<ForestHandler> handler = new ForestHandler(forest);
    ViewScene scene(forest, handler, view, options);
    const osg::ref_ptr<osgGA::KeySwitchMatrixManipulator> manipulators = createManipulators(view);

    const osg::ref_ptr<ClipRecorder> recorder = new ClipRecorder;
    osgViewer::Viewer viewer;
    openWindow(viewer, options.width, options.height);
    viewer.setLightingMode(osg::View::NO_LIGHT);
    viewer.getCamera()->setProjectionMatrixAsPerspective(lens.fieldOfView, lens.aspect, 1.0, 10000.0);
    viewer.getCamera()->setNearFarRatio(1e-5); // near plane 6 cm away with the edge of the ground at 6 km
    viewer.setCameraManipulator(manipulators);
    viewer.addEventHandler(handler);
    viewer.addEventHandler(
        new ViewKeys(scene, forest, handler, manipulators, options.file, options.save, recorder));
    osg::ref_ptr<osgViewer::StatsHandler> statistics = new osgViewer::StatsHandler;
    addStatisticsLines(*statistics);
    viewer.addEventHandler(statistics);
    viewer.addEventHandler(new osgViewer::WindowSizeHandler);
    viewer.addEventHandler(
        new osgViewer::ScreenCaptureHandler(new osgViewer::ScreenCaptureHandler::WriteToFile(
            "view", "png", osgViewer::ScreenCaptureHandler::WriteToFile::SEQUENTIAL_NUMBER)));
    viewer.getCamera()->setPostDrawCallback(recorder);
    viewer.setSceneData(scene.root());
    viewer.realize();
    if (!viewer.isRealized())
        throw noWindow;
    for (int frame = 0; !viewer.done() && (options.frames == 0 || frame < options.frames); ++frame)
        viewer.frame(handler->simulationTime(recorder->referenceTime(viewer.elapsedTime())));
}

} // namespace

void addViewCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("view", "Show a forest in a window, with keys for wind and season");
    auto options = std::make_shared<ViewOptions>();
    command->add_option("file", options->file, "Forest or world to read (.treewind file)")->required();
    command->add_option("--size", options->size, "Width and height of the window, pixels")
        ->capture_default_str();
    command->add_option("--frames", options->frames, "Number of frames to show; 0: until Escape is pressed")
        ->check(CLI::Range(0, 1000000000))
        ->capture_default_str();
    command->add_option(
        "--save", options->save,
        "File that the key w saves the forest to (default: NAME.edited.treewind in the current folder)");
    addSeasonOption(*command, options->season);
    addLightOptions(*command, options->light);
    command->footer("Keys: h shows the keys of the forest, s statistics, f full screen, c takes a picture;\n"
                    "1, 2 and 3 select looking around, walking and flying; Escape closes the window.\n"
                    "Example: osgtreewind view forest.treewind");
    command->callback([options] {
        const PictureSize size = parsePictureSize(options->size, 16384);
        options->width = size.width;
        options->height = size.height;
        if (options->save.empty())
            options->save = stemOf(options->file) + ".edited.treewind";
        show(*options);
    });
}
