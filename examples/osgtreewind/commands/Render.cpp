// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/options/LightOptions.h>
#include <examples/osgtreewind/options/Offscreen.h>
#include <examples/osgtreewind/output/Progress.h>
#include <examples/osgtreewind/pictures/OffscreenViewer.h>
#include <examples/osgtreewind/pictures/VideoWriter.h>
#include <examples/osgtreewind/pictures/WritePicture.h>
#include <examples/osgtreewind/scene/DefaultView.h>
#include <examples/osgtreewind/scene/FeetGround.h>
#include <examples/osgtreewind/scene/Setting.h>

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osgDB/FileNameUtils>
#include <osgUtil/UpdateVisitor>

#include <cmath>
#include <optional>
#include <regex>

namespace {

using namespace osgTreeWind;

struct RenderOptions {
    std::string file, output = "forest.png", size = "1280x720", backend = offscreenBackendName(), pose, tiers,
                      view = "eye";
    ContextProfile profile = osgProfile;
    int frames = 1, samples = 4, width = 0, height = 0;
    double fps = 30.0, start = 0.0, fov = 40.0;
    std::vector<double> eye, center;
    std::optional<float> season;
    TileBox tiles;
    LightOptions light;
};

int samplesAcross(const RenderOptions& options) {
    return static_cast<int>(std::lround(std::sqrt(options.samples)));
}

/// Replaces the first "%04d" (or "%d", "%3d", ...) in the name by the frame number.
std::string framePath(const std::string& pattern, int frame) {
    static const std::regex field("%(0?)([0-9]?)d");
    std::smatch match;
    if (!std::regex_search(pattern, match, field))
        return pattern;
    std::string number = std::to_string(frame);
    const std::size_t width = match[2].length() ? std::stoul(match[2]) : 0;
    if (number.size() < width)
        number.insert(0, width - number.size(), match[1].length() ? '0' : ' ');
    return match.prefix().str() + number + match.suffix().str();
}

/// The view that the options ask for (DefaultView.h).
ForestView viewOf(const RenderOptions& options, const Forest& forest, const Lens& lens) {
    const osg::BoundingSphere& bound = forest.getBound();
    const auto given = [](const std::vector<double>& v) { return osg::Vec3d(v[0], v[1], v[2]); };
    if (options.eye.empty() && options.center.empty() && options.view == "eye")
        return viewAtEyeLevel(forest, lens, options.light.toSun);
    if (options.eye.empty() && options.center.empty() && options.view == "portrait")
        return viewOfOneTree(forest, lens);
    const osg::Vec3d center = options.center.empty() ? osg::Vec3d(bound.center()) : given(options.center);
    if (!options.eye.empty())
        return {given(options.eye), center};
    osg::Vec3d eye = defaultEye(center, bound.radius(), lens);
    if (forest.getGround()) // above the hills between camera and forest
        eye.z() = std::max(eye.z(), groundHeight(forest, {eye.x(), eye.y()}, eye.z()) + 0.1 * bound.radius());
    return {eye, center};
}

void placeCamera(osg::Camera& camera, const ForestView& view, const Lens& lens) {
    const osg::Vec3d direction = view.center - view.eye;
    const bool vertical = direction.x() == 0.0 && direction.y() == 0.0;
    camera.setViewMatrixAsLookAt(view.eye, view.center, vertical ? osg::Y_AXIS : osg::Z_AXIS);
    camera.setProjectionMatrixAsPerspective(lens.fieldOfView, lens.aspect, 1.0, 10000.0);
}

/// Simulates up to --start without drawing, with the same time steps as drawn frames.
void simulateToStart(osg::Node& scene, osg::FrameStamp& stamp, const RenderOptions& options) {
    const auto steps = static_cast<std::size_t>(std::llround(options.start * options.fps));
    osgUtil::UpdateVisitor visitor;
    visitor.setFrameStamp(&stamp);
    Progress progress("simulate to --start", steps);
    for (std::size_t i = 0; i < steps; ++i) {
        stamp.setFrameNumber(stamp.getFrameNumber() + 1);
        stamp.setSimulationTime(static_cast<double>(i) / options.fps);
        scene.accept(visitor);
        progress.advance();
    }
}

bool isVideo(const RenderOptions& options) {
    return osgDB::getLowerCaseFileExtension(options.output) == "mp4";
}

/// Throws CommandError for a wrong name of the output.
void checkOutput(const RenderOptions& options) {
    if (options.frames > 1 && !isVideo(options) && framePath(options.output, 0) == options.output)
        throw CommandError{
            BadInput, "--output: " + std::to_string(options.frames) +
                          " frames need a name with %04d (such as frame_%04d.png), or one that ends in .mp4"};
    if (isVideo(options) && !VideoWriter::available())
        throw CommandError{
            Failed,
            options.output +
                ": MP4 needs the program ffmpeg; install it, or render PNG frames with -o 'frame_%04d.png'"};
    if (!isVideo(options) && osgDB::getLowerCaseFileExtension(options.output) != "png")
        throw CommandError{BadInput,
                           "--output: expected a name that ends in .png or .mp4, found " + options.output};
}

/// Keeps trees drawn by their stand-ins in the next frame; these have the shading of the crown.
void keepStandIns(const BranchwiseForest& forest) {
    for (unsigned i = 0; i < forest.getNumTrees(); ++i)
        branchwiseTrees(forest).nodes()[i]->getLod()->takeFullRequest();
}

/// @param posed forest that shaders pose in all frames; may be null.
void writeFrames(OffscreenViewer& drawing, const BranchwiseForest* posed, const RenderOptions& options) {
    std::optional<AtomicFile> whole;
    std::optional<VideoWriter> movie;
    if (isVideo(options)) {
        whole.emplace(options.output);
        movie.emplace(whole->writePath(), options.width, options.height, options.fps);
    }
    const char* const quick = "PNG_COMPRESSION 1"; // three times faster than the default
    Progress progress("render", static_cast<std::size_t>(options.frames));
    for (int frame = 0; frame < options.frames; ++frame) {
        if (posed)
            keepStandIns(*posed);
        osg::Image& image = drawing.frame(options.start + frame / options.fps);
        if (!movie)
            writePicture(image, framePath(options.output, frame), quick);
        else if (!movie->write(image))
            throwWriteError(*whole);
        progress.advance();
    }
    if (movie && (!movie->close() || !whole->commit()))
        throwWriteError(*whole);
}

void render(const RenderOptions& options) {
    if (options.backend != offscreenBackendName())
        runOtherBackend(options.backend);
    checkOutput(options);
    ForestDescription description = loadForest(options.file, options.tiles);
    if (!options.tiers.empty())
        description.drawing.tiers = options.tiers == "on";
    description.season = options.season.value_or(description.season);
    if (!description.ground)
        description.ground = groundThroughFeet(description);
    const osg::ref_ptr<Forest> forest =
        valueOrThrow(Forest::create(std::move(description)), BadInput, options.file);
    const Lens lens{options.fov, static_cast<double>(options.width) / options.height};
    const ForestView view = viewOf(options, *forest, lens);
    osg::ref_ptr<osg::Group> scene =
        createSetting(*forest, {options.light.shadows, options.light.day(), view.eye});

    OffscreenViewer drawing(options.width, options.height, samplesAcross(options), options.profile);
    osgViewer::Viewer& viewer = drawing.viewer();
    placeCamera(*viewer.getCamera(), view, lens);
    const BranchwiseForest* posed = nullptr;
    if (BranchwiseForest* branchwise = forest->getBranchwise()) {
        const bool onCpu = options.pose.empty() || options.pose == "cpu";
        branchwise->setAngleSource(onCpu ? BranchwiseForest::CPU_ANGLES : BranchwiseForest::GPU_ANGLES);
        if (options.pose != "scenegraph")
            posed = branchwise;
    } else if (!options.pose.empty())
        throw CommandError{
            BadInput,
            "--pose: expected a forest under the law \"thesis\" or \"thesis-smooth\", found \"modal\""};
    viewer.setSceneData(scene);
    viewer.realize();
    simulateToStart(*scene, *viewer.getFrameStamp(), options);
    writeFrames(drawing, posed, options);
}

void addViewOptions(CLI::App& command, RenderOptions& options) {
    command
        .add_option("--view", options.view,
                    "View: eye (at eye level before the forest), above (all of it, from above) or portrait "
                    "(the tree nearest to the middle)")
        ->check(CLI::IsMember({"eye", "above", "portrait"}))
        ->capture_default_str();
    command
        .add_option("--eye", options.eye, "Position of the camera instead of --view: X,Y,Z in the scene, m")
        ->delimiter(',')
        ->expected(3)
        ->check(between(-1e7, 1e7));
    command
        .add_option("--center", options.center,
                    "Point that the camera looks at: X,Y,Z in the scene, m (default: middle of the forest)")
        ->delimiter(',')
        ->expected(3)
        ->check(between(-1e7, 1e7));
    command.add_option("--fov", options.fov, "Vertical field of view, degrees")
        ->check(between(1.0, 170.0))
        ->capture_default_str();
}

} // namespace

void addRenderCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand("render", "Draw pictures or a video without a display");
    auto options = std::make_shared<RenderOptions>();
    command->add_option("file", options->file, "Forest or world to read (.treewind file)")->required();
    command
        ->add_option("-o,--output", options->output,
                     "Output file: NAME.png, NAME_%04d.png for numbered frames, or NAME.mp4")
        ->capture_default_str();
    command->add_option("--size", options->size, "Width and height of the picture, pixels")
        ->capture_default_str();
    command->add_option("--frames", options->frames, "Number of frames")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--fps", options->fps, "Frames per second of simulation time")
        ->check(between(0.001, 10000.0))
        ->capture_default_str();
    command
        ->add_option("--start", options->start,
                     "Simulation time of the first frame, s; the forest starts at rest at time 0")
        ->check(between(0.0, 1e6))
        ->capture_default_str();
    addViewOptions(*command, *options);
    addSeasonOption(*command, options->season);
    addTilesOption(*command, options->tiles);
    addLightOptions(*command, options->light);
    command
        ->add_option("--samples", options->samples,
                     "Samples per pixel for smooth edges; drawing time grows in proportion")
        ->check(CLI::IsMember({1, 4, 9, 16}))
        ->capture_default_str();
    addBackendOption(*command, options->backend);
    addProfileOption(*command, options->profile);
    command
        ->add_option("--tiers", options->tiers,
                     "Levels of detail (law modal): off draws every tree in full (default: as in the file)")
        ->check(CLI::IsMember({"on", "off"}));
    command
        ->add_option("--pose", options->pose,
                     "Branch motion (thesis laws): cpu or gpu computes the angles, scenegraph also moves "
                     "branches by OSG transforms; default: cpu")
        ->check(CLI::IsMember({"cpu", "gpu", "scenegraph"}));
    command->footer(
        "The same file and arguments give the same pixels.\n"
        "Example: osgtreewind render forest.treewind -o clip.mp4 --size 1920x1080 --frames 300 --fps 30");
    command->callback([options] {
        const PictureSize size = parsePictureSize(options->size, maxOffscreenSize / samplesAcross(*options));
        options->width = size.width;
        options->height = size.height;
        if (!options->eye.empty() && options->eye == options->center)
            throw CLI::ValidationError("--eye", "expected a point that differs from --center");
        render(*options);
    });
}
