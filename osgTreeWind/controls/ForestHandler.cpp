// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/ForestHandler.h>

#include <osgTreeWind/controls/ForestControls.h>
#include <osgTreeWind/controls/FormattedText.h>
#include <osgTreeWind/controls/SelectedTree.h>
#include <osgTreeWind/controls/TextPanel.h>
#include <osgTreeWind/controls/WindArrows.h>
#include <osgTreeWind/controls/WindStreaks.h>
#include <osgTreeWind/drawing/instanced/DrawnTrees.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/drawing/instanced/TreeHit.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <osg/ApplicationUsage>
#include <osg/View>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

using Event = osgGA::GUIEventAdapter;

struct KeyBinding {
    int key;
    const char *name, *description;
    void (*act)(ForestControls&);
};

const KeyBinding keys[] = {
    {Event::KEY_Up, "Up", "stronger wind", [](ForestControls& f) { f.changeSpeed(1.0); }},
    {Event::KEY_Down, "Down", "weaker wind", [](ForestControls& f) { f.changeSpeed(-1.0); }},
    {Event::KEY_Right, "Right", "turn the wind clockwise", [](ForestControls& f) { f.turnWind(15.0); }},
    {Event::KEY_Left, "Left", "turn the wind counter-clockwise",
     [](ForestControls& f) { f.turnWind(-15.0); }},
    {Event::KEY_Page_Up, "PageUp", "stronger gusts", [](ForestControls& f) { f.changeGustiness(0.05); }},
    {Event::KEY_Page_Down, "PageDown", "weaker gusts", [](ForestControls& f) { f.changeGustiness(-0.05); }},
    {'0', "0", "original wind", [](ForestControls& f) { f.restoreWind(); }},
    {']', "]", "later in the year", [](ForestControls& f) { f.changeSeason(0.1f); }},
    {'[', "[", "earlier in the year", [](ForestControls& f) { f.changeSeason(-0.1f); }},
    {'p', "p", "pause or continue", [](ForestControls& f) { f.togglePause(); }},
    {'n', "n", "step by 1/30 s", [](ForestControls& f) { f.step(); }},
    {'+', "+", "faster clock", [](ForestControls& f) { f.changeClockRate(2.0); }},
    {'-', "-", "slower clock", [](ForestControls& f) { f.changeClockRate(0.5); }},
    {'m', "m", "next law of motion", [](ForestControls& f) { f.nextLaw(); }},
    {'g', "g", "half the response to the wind", [](ForestControls& f) { f.changeGain(0.5f); }},
    {'G', "G", "twice the response to the wind", [](ForestControls& f) { f.changeGain(2.0f); }},
    {'d', "d", "damage by wind on or off", [](ForestControls& f) { f.toggleDamage(); }},
    {'v', "v", "far trees in full detail or in tiers", [](ForestControls& f) { f.toggleTiers(); }},
    {'V', "V", "colours of the tiers on or off", [](ForestControls& f) { f.toggleTierColors(); }},
    {'R', "R", "keep the wind source; r adds another", [](ForestControls& f) { f.keepSource(); }},
    {Event::KEY_Delete, "Delete", "remove the last wind source", [](ForestControls& f) { f.removeSource(); }},
    {'b', "b", "coarser far trees if frames take over 33 ms, on or off",
     [](ForestControls& f) { f.toggleBudget(); }},
};
struct Switch {
    int key;
    const char *name, *description;
};
constexpr Switch sourceKey{
    'r', "r", "next wind source at the clicked tree: helicopter, fan, vortex, shelter, explosion, none"},
    arrowsKey{'a', "a", "arrows of the wind"}, streaksKey{'A', "A", "paths of the air near the camera"},
    panelKey{'i', "i", "status text"}, helpKey{'h', "h", "list of the keys"};
constexpr const char* clickName = "click";
constexpr const char* clickEffect = "data of a tree";

template <class Visit>
void forEachKey(const Visit& visit) {
    for (const KeyBinding& key : keys)
        visit(key.name, key.description);
    for (const Switch& key : {sourceKey, arrowsKey, streaksKey, panelKey, helpKey})
        visit(key.name, key.description);
    visit(clickName, clickEffect);
}

std::string helpText() {
    std::string text;
    forEachKey([&](const char* name, const char* description) {
        text += formatted(text.empty() ? "%-9s %s" : "\n%-9s %s", name, description);
    });
    return text;
}

/// From the scene's root to the forest's frame.
osg::Matrix toForest(Forest& forest) {
    const osg::NodePathList paths = forest.getParentalNodePaths();
    return paths.empty() ? osg::Matrix() : osg::computeWorldToLocal(paths.front());
}

std::string drawnText(Forest& forest) {
    std::string text = formatted("\ntrees   %zu", forest.getNumTrees());
    if (!forest.getInstanced())
        return text;
    const DrawnTrees drawn(instancedTrees(*forest.getInstanced()).treesByTier());
    return text + formatted("; drawn: %zu in full detail, %zu by boughs, %zu as pictures", drawn.full,
                            drawn.byBoughs, drawn.asPictures);
}

} // namespace

class ForestHandler::State {
public:
    explicit State(Forest* forest) : controls(forest) {}

    bool handle(const Event& event, osg::View& view);

    ExceptionGuard guard;
    ForestControls controls;
    TextPanel panel;
    std::optional<SelectedTree> selected;
    unsigned unit = 0;

private:
    bool handleKey(int key);
    void selectTree(const Event& event, osg::View& view);
    void updateOverlay(double now, osg::View& view);
    void placeSource();
    void updateWindOverlay(Forest& forest, osg::View& view);
    std::string statusText(Forest& forest) const;

    osg::ref_ptr<WindArrows> _arrows = new WindArrows;
    osg::ref_ptr<WindStreaks> _streaks = new WindStreaks;
    bool _showsText = true, _showsHelp = false, _showsArrows = false, _showsStreaks = false;
    double _lastTextTime = -1.0, _frameTime = 0.0; ///< Seconds.
    unsigned _frames = 0;                          ///< Since `_lastTextTime`.
    std::optional<osg::Vec3d> _sourceFoot;         ///< Foot of the clicked tree, in the wind's frame.
    double _sourceHeight = 0.0;
    double _time = 0.0; ///< Of the simulation.
    const ForestSimulation* _selectedIn = nullptr;
    float _pushedX = 0.0f, _pushedY = 0.0f;
};

bool ForestHandler::State::handleKey(int key) {
    _lastTextTime = -1.0;
    const auto* found =
        std::find_if(std::begin(keys), std::end(keys), [key](const KeyBinding& k) { return k.key == key; });
    if (found != std::end(keys))
        found->act(controls);
    else if (key == sourceKey.key)
        placeSource();
    else if (key == arrowsKey.key)
        _showsArrows = !_showsArrows;
    else if (key == streaksKey.key)
        _showsStreaks = !_showsStreaks;
    else if (key == panelKey.key)
        _showsText = !_showsText;
    else if (key == helpKey.key)
        _showsHelp = !_showsHelp;
    else
        return false;
    return true;
}

void ForestHandler::State::placeSource() {
    Forest& forest = *controls.forest();
    const ForestSimulation& simulation = forest.getSimulation();
    if (selected && simulation.holds(selected->id())) {
        const PlacedTree& tree = movingForest(simulation).trees()[slotOfTree(selected->id())];
        _sourceFoot = toOsg(tree.position);
        if (forest.getWind().frame == WindFrame::Scene)
            *_sourceFoot = *_sourceFoot * osg::Matrix::inverse(toForest(forest));
        _sourceHeight = static_cast<double>(movingForest(simulation).placed().sizeOf(tree).height);
    }
    if (_sourceFoot) // a tree was clicked before
        controls.nextSource({_sourceFoot->x(), _sourceFoot->y(), _sourceFoot->z()}, _sourceHeight, _time);
}

void ForestHandler::State::selectTree(const Event& event, osg::View& view) {
    constexpr float maxDrag = 3.0f; // pixels
    Forest* forest = controls.forest();
    if (std::abs(event.getX() - _pushedX) > maxDrag || std::abs(event.getY() - _pushedY) > maxDrag)
        return; // the camera was moved
    osg::ref_ptr<osgUtil::LineSegmentIntersector> line = new osgUtil::LineSegmentIntersector(
        osgUtil::Intersector::PROJECTION, event.getXnormalized(), event.getYnormalized());
    osgUtil::IntersectionVisitor visitor(line);
    view.getCamera()->accept(visitor);
    _lastTextTime = -1.0;
    selected.reset();
    for (const osgUtil::LineSegmentIntersector::Intersection& hit : line->getIntersections()) {
        const auto* tree = dynamic_cast<const TreeHit*>(hit.drawable.get());
        if (!tree || !tree->getTree() ||
            std::find(hit.nodePath.begin(), hit.nodePath.end(), forest) == hit.nodePath.end())
            continue;
        _selectedIn = &forest->getSimulation();
        selected.emplace(*_selectedIn, *tree->getTree());
        unit = tree->getUnit(hit.primitiveIndex);
        return;
    }
}

std::string ForestHandler::State::statusText(Forest& forest) const {
    std::string text = controls.text() + drawnText(forest) + formatted("\nframe   %.1f ms", 1e3 * _frameTime);
    if (const std::string tree = selected ? selected->text(forest.getSimulation()) : ""; !tree.empty())
        text += '\n' + tree;
    if (!controls.error().empty())
        text += "\nerror   " + controls.error();
    return text + "\n\nh       keys";
}

void ForestHandler::State::updateWindOverlay(Forest& forest, osg::View& view) {
    constexpr float most = 300.0f; // metres
    osg::Vec3d eye, centre, up;
    view.getCamera()->getViewMatrixAsLookAt(eye, centre, up);
    const osg::BoundingSphere& bound = forest.getBound();
    const bool isAll = bound.radius() < most;
    const osg::Vec3d middle = isAll ? osg::Vec3d(bound.center()) : eye * toForest(forest);
    const auto show = [&](auto& picture, bool isShown, const osg::Vec3d& about, float reach) {
        if (!isShown) {
            forest.removeChild(picture);
            return;
        }
        picture->show(forest.getSimulation(), view.getFrameStamp()->getSimulationTime(),
                      {static_cast<float>(about.x()), static_cast<float>(about.y())}, reach);
        if (!forest.containsNode(picture))
            forest.addChild(picture);
    };
    show(_arrows, _showsArrows, middle, isAll ? bound.radius() : most);
    constexpr float range = 50.0f; // metres
    osg::Vec3d ahead = centre - eye;
    ahead.normalize();
    show(_streaks, _showsStreaks, (eye + ahead * 0.8 * range) * toForest(forest), range);
}

void ForestHandler::State::updateOverlay(double now, osg::View& view) {
    constexpr double textInterval = 0.2; // seconds
    Forest& forest = *controls.forest();
    if (const osg::Viewport* viewport = view.getCamera()->getViewport())
        panel.setSize(static_cast<int>(viewport->width()), static_cast<int>(viewport->height()));
    updateWindOverlay(forest, view);
    _time = view.getFrameStamp()->getSimulationTime();
    if (_selectedIn != &forest.getSimulation())
        selected.reset(); // the forest has other trees now
    ++_frames;
    if (_lastTextTime >= 0.0 && now - _lastTextTime < textInterval)
        return;
    if (_lastTextTime >= 0.0)
        _frameTime = (now - _lastTextTime) / _frames;
    panel.show(_showsText ? statusText(forest) : "", _showsHelp ? helpText() : "");
    _lastTextTime = now;
    _frames = 0;
}

/// @return whether the event is handled.
bool ForestHandler::State::handle(const Event& event, osg::View& view) {
    switch (event.getEventType()) {
    case Event::FRAME:
        updateOverlay(event.getTime(), view);
        return false;
    case Event::KEYDOWN:
        return handleKey(event.getKey());
    case Event::PUSH:
        _pushedX = event.getX();
        _pushedY = event.getY();
        return false;
    case Event::RELEASE:
        if (event.getButton() == Event::LEFT_MOUSE_BUTTON)
            selectTree(event, view);
        return false;
    default:
        return false;
    }
}

ForestHandler::ForestHandler(Forest* forest) : _state(std::make_unique<State>(forest)) {}

ForestHandler::~ForestHandler() = default;

osg::Node* ForestHandler::getOverlay() const {
    return _state->panel.camera();
}

double ForestHandler::simulationTime(double referenceTime) {
    return _state->controls.simulationTime(referenceTime);
}

std::optional<TreeId> ForestHandler::getTree() const {
    return _state->selected ? std::optional(_state->selected->id()) : std::nullopt;
}

unsigned ForestHandler::getUnit() const {
    return _state->unit;
}

bool ForestHandler::handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action) {
    osg::View* view = action.asView();
    bool handled = false;
    if (!event.getHandled() && view && _state->controls.forest())
        _state->guard.run("a key, a click or the status text has no effect",
                          [&] { handled = _state->handle(event, *view); });
    return handled;
}

void ForestHandler::getUsage(osg::ApplicationUsage& usage) const {
    forEachKey([&](const char* name, const char* description) {
        usage.addKeyboardMouseBinding(std::string("Forest: ") + name, description);
    });
}

} // namespace osgTreeWind
