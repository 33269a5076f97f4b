// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/options/LightOptions.h>
#include <examples/osgtreewind/options/Offscreen.h>
#include <examples/osgtreewind/options/Setting.h>
#include <examples/osgtreewind/pictures/ClipRecorder.h>
#include <examples/osgtreewind/scene/DefaultView.h>
#include <examples/osgtreewind/scene/FeetGround.h>

#include <osgTreeWind/controls/ForestHandler.h>
#include <osgTreeWind/controls/StatisticsLines.h>
#include <osgTreeWind/drawing/BranchTransform.h>
#include <osgTreeWind/forest/ForestTiles.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

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

/// A forest, all that is around it, and what its handler shows.
class Stage {
public:
    Stage(Forest* forest, ForestHandler* handler, const ForestView& view, const ViewOptions& options)
        : _forest(forest), _root(new osg::Group), _view(view), _light(options.light) {
        _root->addChild(handler->getOverlay());
        light();
    }
    osg::Group* root() const { return _root.get(); }

    /// Turns the sky as the Earth does in that time, as long as the sun is up.
    void turnSky(double hours) {
        constexpr double latitude = 50.0, degreesAnHour = 15.0; // central Europe's; nobody says where this is
        const osg::Vec3d pole(0.0, std::cos(osg::DegreesToRadians(latitude)),
                              std::sin(osg::DegreesToRadians(latitude)));
        const osg::Vec3 sun = osg::Quat(-osg::DegreesToRadians(degreesAnHour * hours), pole) * _light.toSun;
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

/// The keys that are this program's and not the forest's.
class StageKeys : public osgGA::GUIEventHandler {
public:
    StageKeys(Stage& stage, Forest* forest, ForestHandler* handler, osgGA::KeySwitchMatrixManipulator* ways,
              std::string file, std::string save, ClipRecorder* recorder)
        : _stage(stage), _forest(forest), _handler(handler), _ways(ways), _file(std::move(file)),
          _save(std::move(save)), _recorder(recorder) {}

    using osgGA::GUIEventHandler::handle;
    bool handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter&) override {
        if (event.getHandled() || event.getEventType() != osgGA::GUIEventAdapter::KEYDOWN)
            return false;
        switch (event.getKey()) {
        case 'k':
            _stage.turnSky(0.5);
            return true;
        case 'K':
            _stage.turnSky(-0.5);
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
        usage.addKeyboardMouseBinding("View: k, K", "later, earlier in the day");
        usage.addKeyboardMouseBinding("View: w", "write the forest as it is, to " + _save);
        usage.addKeyboardMouseBinding("View: C", "begin or end a clip");
        usage.addKeyboardMouseBinding("View: x", "ride on the branch that was clicked");
    }

private:
    void write() {
        const Diagnostics problems = editForestFile(_forest->getSimulation().describe(), _file, _save);
        if (problems.empty())
            std::cout << "wrote " << _save << std::endl;
        else
            std::cerr << linesOf(problems) << std::endl;
    }

    void follow() {
        const Result<BranchTransform*> branch = _forest->branch(_handler->getTree(), _handler->getUnit());
        if (!branch)
            return;
        osg::ref_ptr<osgGA::NodeTrackerManipulator> way = new osgGA::NodeTrackerManipulator;
        way->setTrackNode(branch.value());
        way->setTrackerMode(osgGA::NodeTrackerManipulator::NODE_CENTER);
        way->setDistance(6.0);
        _ways->addMatrixManipulator('4', "Branch", way);
        _ways->selectMatrixManipulator(_ways->getNumMatrixManipulators() - 1);
    }

    Stage& _stage;
    osg::ref_ptr<Forest> _forest;
    osg::ref_ptr<ForestHandler> _handler;
    osg::ref_ptr<osgGA::KeySwitchMatrixManipulator> _ways;
    std::string _file, _save;
    osg::ref_ptr<ClipRecorder> _recorder;
};

/// Of a world's middle, or as a person stands before a forest.
ForestView firstView(const Forest& forest, const Lens& lens, const osg::Vec3& sun) {
    constexpr double aboveGround = 40.0, ahead = 300.0; // metres
    if (!forest.getDescription().tiles)
        return viewAtEyeLevel(forest, lens, sun);
    const osg::Vec3d centre = forest.getBound().center();
    const osg::Vec3d eye(centre.x(), centre.y(),
                         groundHeight(forest, {centre.x(), centre.y()}, centre.z()) + aboveGround);
    return {eye, eye + osg::Vec3d(0.0, ahead, -0.5 * aboveGround)};
}

osg::ref_ptr<osgGA::KeySwitchMatrixManipulator> waysToLook(const ForestView& view) {
    osg::ref_ptr<osgGA::KeySwitchMatrixManipulator> ways = new osgGA::KeySwitchMatrixManipulator;
    ways->addMatrixManipulator('1', "Around", new osgGA::TerrainManipulator);
    ways->addMatrixManipulator('2', "Walk", new osgGA::FirstPersonManipulator);
    ways->addMatrixManipulator('3', "Fly", new osgGA::FlightManipulator);
    ways->setHomePosition(view.eye, view.center, osg::Z_AXIS);
    return ways;
}

void show(const ViewOptions& options) {
    if (offscreenBackendName() != std::string("egl"))
        runOtherBackend("egl"); // windows need the system's OpenGL
    auto description = readForestFile(options.file);
    if (!description)
        throw Ending{BadInput, linesOf(description.problems())};
    printNotes(options.file, description.value().notes);
    description.value().season = options.season.value_or(description.value().season);
    if (!description.value().ground && !description.value().tiles)
        description.value().ground = groundThroughFeet(description.value());
    const osg::ref_ptr<Forest> forest =
        valueOf(Forest::create(std::move(description.value())), BadInput, options.file);
    const Lens lens{40.0, static_cast<double>(options.width) / options.height};
    const ForestView view = firstView(*forest, lens, options.light.toSun);
    osg::ref_ptr<ForestHandler> handler = new ForestHandler(forest);
    Stage stage(forest, handler, view, options);
    const osg::ref_ptr<osgGA::KeySwitchMatrixManipulator> ways = waysToLook(view);

    const osg::ref_ptr<ClipRecorder> recorder = new ClipRecorder;
    osg::DisplaySettings::instance()->setMinimumNumAlphaBits(8);   // the setting's shadows lie there,
    osg::DisplaySettings::instance()->setMinimumNumStencilBits(8); // and where they do here
    if (std::string samples; !osg::getEnvVar("OSG_MULTI_SAMPLES", samples))
        osg::DisplaySettings::instance()->setNumMultiSamples(4);
    osgViewer::Viewer viewer;
    viewer.setUpViewInWindow(60, 60, options.width, options.height);
    viewer.setLightingMode(osg::View::NO_LIGHT);
    viewer.getCamera()->setProjectionMatrixAsPerspective(lens.fieldOfView, lens.aspect, 1.0, 10000.0);
    viewer.getCamera()->setNearFarRatio(1e-5); // 6 cm before the eye, with the ground's rim at 6 km
    viewer.setCameraManipulator(ways);
    viewer.addEventHandler(handler);
    viewer.addEventHandler(new StageKeys(stage, forest, handler, ways, options.file, options.save, recorder));
    osg::ref_ptr<osgViewer::StatsHandler> statistics = new osgViewer::StatsHandler;
    addStatisticsLines(*statistics);
    viewer.addEventHandler(statistics);
    viewer.addEventHandler(new osgViewer::WindowSizeHandler);
    viewer.addEventHandler(
        new osgViewer::ScreenCaptureHandler(new osgViewer::ScreenCaptureHandler::WriteToFile(
            "view", "png", osgViewer::ScreenCaptureHandler::WriteToFile::SEQUENTIAL_NUMBER)));
    viewer.getCamera()->setPostDrawCallback(recorder);
    viewer.setSceneData(stage.root());
    viewer.realize();
    if (!viewer.isRealized())
        throw Ending{Failed, "view: no window opens here; osgtreewind render draws pictures without one"};
    for (int frame = 0; !viewer.done() && (options.frames == 0 || frame < options.frames); ++frame)
        viewer.frame(handler->simulationTime(recorder->referenceTime(viewer.elapsedTime())));
}

} // namespace

void addViewCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("view", "Show a forest in a window, with keys for wind and season");
    auto options = std::make_shared<ViewOptions>();
    command->add_option("file", options->file, "A .treewind file, or a world's")->required();
    command->add_option("--size", options->size, "Width and height in pixels")->capture_default_str();
    command->add_option("--frames", options->frames, "End after so many; 0: with escape")
        ->check(CLI::Range(0, 1000000000))
        ->capture_default_str();
    command->add_option("--save", options->save,
                        "Where the key w writes the forest as it is; by default FILE.edited.treewind, here");
    addSeasonOption(*command, options->season);
    addLightOptions(*command, options->light);
    command->footer("In the window: h shows the keys of the forest; s statistics, f full screen, c writes a "
                    "picture,\n1, 2 and 3 are ways to look around, walk and fly, escape ends it.\n"
                    "Example: osgtreewind view forest.treewind");
    command->callback([options] {
        const PictureSize size = parsePictureSize(options->size, 16384);
        options->width = size.width;
        options->height = size.height;
        if (options->save.empty())
            options->save = std::filesystem::path(options->file).stem().string() + ".edited.treewind";
        show(*options);
    });
}
