// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/ForestHandler.h>

#include <osgTreeWind/controls/ForestControls.h>
#include <osgTreeWind/controls/FormattedText.h>
#include <osgTreeWind/controls/TextPanel.h>
#include <osgTreeWind/controls/WatchedTree.h>
#include <osgTreeWind/controls/WindArrows.h>
#include <osgTreeWind/controls/WindStreaks.h>
#include <osgTreeWind/drawing/instanced/DrawnTrees.h>
#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedParts.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/drawing/instanced/TreeHit.h>
#include <osgTreeWind/gpu/EntryGuard.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/SimulationParts.h>

#include <osg/ApplicationUsage>
#include <osg/View>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

using Event = osgGA::GUIEventAdapter;

struct Key {
    int key;
    const char *name, *does;
    void (*act)(ForestControls&);
};

const Key keys[] = {
    {Event::KEY_Up, "Up", "a stronger wind", [](ForestControls& f) { f.changeSpeed(1.0); }},
    {Event::KEY_Down, "Down", "a weaker wind", [](ForestControls& f) { f.changeSpeed(-1.0); }},
    {Event::KEY_Right, "Right", "turn the wind clockwise", [](ForestControls& f) { f.turnWind(15.0); }},
    {Event::KEY_Left, "Left", "turn it back", [](ForestControls& f) { f.turnWind(-15.0); }},
    {Event::KEY_Page_Up, "PageUp", "gustier", [](ForestControls& f) { f.changeGustiness(0.05); }},
    {Event::KEY_Page_Down, "PageDown", "steadier", [](ForestControls& f) { f.changeGustiness(-0.05); }},
    {'0', "0", "the wind that was given", [](ForestControls& f) { f.restoreWind(); }},
    {']', "]", "later in the year", [](ForestControls& f) { f.changeSeason(0.1f); }},
    {'[', "[", "earlier in the year", [](ForestControls& f) { f.changeSeason(-0.1f); }},
    {'p', "p", "pause, and go on", [](ForestControls& f) { f.pause(); }},
    {'n', "n", "a thirtieth of a second on", [](ForestControls& f) { f.step(); }},
    {'+', "+", "time goes faster", [](ForestControls& f) { f.changePace(2.0); }},
    {'-', "-", "time goes slower", [](ForestControls& f) { f.changePace(0.5); }},
    {'m', "m", "the next law of motion", [](ForestControls& f) { f.nextLaw(); }},
    {'g', "g", "half the answer to the wind", [](ForestControls& f) { f.changeGain(0.5f); }},
    {'G', "G", "twice the answer to the wind", [](ForestControls& f) { f.changeGain(2.0f); }},
    {'d', "d", "the wind brings down trees, or none", [](ForestControls& f) { f.switchDamage(); }},
    {'v', "v", "far trees in full, or in tiers", [](ForestControls& f) { f.switchTiers(); }},
    {'V', "V", "trees in the colours of their tiers, or in their own",
     [](ForestControls& f) { f.switchTierColors(); }},
    {'R', "R", "the source of wind stays, r puts another", [](ForestControls& f) { f.keepSource(); }},
    {Event::KEY_Delete, "Delete", "take away the last source", [](ForestControls& f) { f.removeSource(); }},
    {'b', "b", "far trees coarser where frames take over 33 ms, or not",
     [](ForestControls& f) { f.switchBudget(); }},
};
struct Switch {
    int key;
    const char *name, *does;
};
constexpr Switch sourceKey{
    'r', "r", "a helicopter, a fan, a whirl, a shelter, an explosion or none at the tree clicked"},
    arrowsKey{'a', "a", "arrows of the wind"}, streaksKey{'A', "A", "streaks that travel with the wind"},
    panelKey{'i', "i", "the text at the left"}, helpKey{'h', "h", "these keys"};
constexpr const char* clickName = "click";
constexpr const char* clickDoes = "what a tree is, and how it sways";

template <class Visit>
void forEachKey(const Visit& visit) {
    for (const Key& key : keys)
        visit(key.name, key.does);
    for (const Switch& key : {sourceKey, arrowsKey, streaksKey, panelKey, helpKey})
        visit(key.name, key.does);
    visit(clickName, clickDoes);
}

std::string helpText() {
    std::string text;
    forEachKey([&](const char* name, const char* does) {
        text += formatted(text.empty() ? "%-9s %s" : "\n%-9s %s", name, does);
    });
    return text;
}

/// Into the forest's frame.
osg::Matrix toForest(Forest& forest) {
    const osg::NodePathList paths = forest.getParentalNodePaths();
    return paths.empty() ? osg::Matrix() : osg::computeWorldToLocal(paths.front());
}

std::string drawnText(Forest& forest) {
    std::string text = formatted("\ntrees   %zu", forest.getNumTrees());
    if (!forest.getInstanced())
        return text;
    const DrawnTrees drawn(InstancedParts::trees(*forest.getInstanced())->listedTrees());
    return text + formatted("; drawn %zu in full, %zu by boughs, %zu as pictures", drawn.full, drawn.byBoughs,
                            drawn.asPictures);
}

} // namespace

class ForestHandler::State {
public:
    explicit State(Forest* forest) : controls(forest) {}

    bool handle(const Event& event, osg::View& view);

    EntryGuard guard;
    ForestControls controls;
    TextPanel panel;
    std::optional<WatchedTree> watched;
    unsigned unit = 0;

private:
    bool press(int key);
    void pick(const Event& event, osg::View& view);
    void refresh(double now, osg::View& view);
    void putSource();
    void showWind(Forest& forest, osg::View& view);
    std::string statusText(Forest& forest) const;

    osg::ref_ptr<WindArrows> _arrows = new WindArrows;
    osg::ref_ptr<WindStreaks> _streaks = new WindStreaks;
    bool _withText = true, _withHelp = false, _withArrows = false, _withStreaks = false;
    double _shownAt = -1.0, _frameTime = 0.0; ///< Seconds.
    unsigned _frames = 0;                     ///< Since then.
    std::optional<osg::Vec3d> _sourceFoot;    ///< Of the tree it is put to, in the wind's frame.
    double _sourceHeight = 0.0;
    double _time = 0.0; ///< Of the simulation.
    const ForestSimulation* _watchedIn = nullptr;
    float _pushedX = 0.0f, _pushedY = 0.0f;
};

bool ForestHandler::State::press(int key) {
    _shownAt = -1.0;
    const auto* found =
        std::find_if(std::begin(keys), std::end(keys), [key](const Key& k) { return k.key == key; });
    if (found != std::end(keys))
        found->act(controls);
    else if (key == sourceKey.key)
        putSource();
    else if (key == arrowsKey.key)
        _withArrows = !_withArrows;
    else if (key == streaksKey.key)
        _withStreaks = !_withStreaks;
    else if (key == panelKey.key)
        _withText = !_withText;
    else if (key == helpKey.key)
        _withHelp = !_withHelp;
    else
        return false;
    return true;
}

void ForestHandler::State::putSource() {
    Forest& forest = *controls.forest();
    const ForestSimulation& simulation = forest.getSimulation();
    if (watched && simulation.holds(watched->id())) {
        const PlacedTree& tree = SimulationParts::forest(simulation).trees[simulation.slotOf(watched->id())];
        _sourceFoot = toOsg(tree.position);
        if (forest.getWind().frame == WindFrame::Scene)
            *_sourceFoot = *_sourceFoot * osg::Matrix::inverse(toForest(forest));
        _sourceHeight = static_cast<double>(SimulationParts::forest(simulation).measured(tree).height);
    }
    if (_sourceFoot) // else nothing was clicked yet
        controls.nextSource({_sourceFoot->x(), _sourceFoot->y(), _sourceFoot->z()}, _sourceHeight, _time);
}

void ForestHandler::State::pick(const Event& event, osg::View& view) {
    constexpr float still = 3.0f; // pixels
    Forest* forest = controls.forest();
    if (std::abs(event.getX() - _pushedX) > still || std::abs(event.getY() - _pushedY) > still)
        return; // the camera was moved
    osg::ref_ptr<osgUtil::LineSegmentIntersector> line = new osgUtil::LineSegmentIntersector(
        osgUtil::Intersector::PROJECTION, event.getXnormalized(), event.getYnormalized());
    osgUtil::IntersectionVisitor visitor(line);
    view.getCamera()->accept(visitor);
    _shownAt = -1.0;
    watched.reset();
    for (const osgUtil::LineSegmentIntersector::Intersection& hit : line->getIntersections()) {
        const auto* tree = dynamic_cast<const TreeHit*>(hit.drawable.get());
        if (!tree || std::find(hit.nodePath.begin(), hit.nodePath.end(), forest) == hit.nodePath.end())
            continue;
        _watchedIn = &forest->getSimulation();
        watched.emplace(*_watchedIn, tree->getTree());
        unit = tree->getUnit(hit.primitiveIndex);
        return;
    }
}

std::string ForestHandler::State::statusText(Forest& forest) const {
    std::string text = controls.text() + drawnText(forest) + formatted("\nframe   %.1f ms", 1e3 * _frameTime);
    if (const std::string tree = watched ? watched->text(forest.getSimulation()) : ""; !tree.empty())
        text += '\n' + tree;
    if (!controls.message().empty())
        text += "\nnot     " + controls.message();
    return text + "\n\nh       keys";
}

void ForestHandler::State::showWind(Forest& forest, osg::View& view) {
    constexpr float most = 300.0f; // metres
    osg::Vec3d eye, centre, up;
    view.getCamera()->getViewMatrixAsLookAt(eye, centre, up);
    const osg::BoundingSphere& bound = forest.getBound();
    const bool isAll = bound.radius() < most;
    const osg::Vec3d middle = isAll ? osg::Vec3d(bound.center()) * toForest(forest) : eye * toForest(forest);
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
    show(_arrows, _withArrows, middle, isAll ? bound.radius() : most);
    constexpr float near = 50.0f; // metres
    osg::Vec3d ahead = centre - eye;
    ahead.normalize();
    show(_streaks, _withStreaks, (eye + ahead * 0.8 * near) * toForest(forest), near);
}

void ForestHandler::State::refresh(double now, osg::View& view) {
    constexpr double patience = 0.2; // seconds
    Forest& forest = *controls.forest();
    if (const osg::Viewport* viewport = view.getCamera()->getViewport())
        panel.setSize(static_cast<int>(viewport->width()), static_cast<int>(viewport->height()));
    showWind(forest, view);
    _time = view.getFrameStamp()->getSimulationTime();
    if (_watchedIn != &forest.getSimulation())
        watched.reset(); // other trees are there
    ++_frames;
    if (_shownAt >= 0.0 && now - _shownAt < patience)
        return;
    if (_shownAt >= 0.0)
        _frameTime = (now - _shownAt) / _frames;
    panel.show(_withText ? statusText(forest) : "", _withHelp ? helpText() : "");
    _shownAt = now;
    _frames = 0;
}

/// @return whether nobody else is to handle it.
bool ForestHandler::State::handle(const Event& event, osg::View& view) {
    switch (event.getEventType()) {
    case Event::FRAME:
        refresh(event.getTime(), view);
        return false;
    case Event::KEYDOWN:
        return press(event.getKey());
    case Event::PUSH:
        _pushedX = event.getX();
        _pushedY = event.getY();
        return false;
    case Event::RELEASE:
        if (event.getButton() == Event::LEFT_MOUSE_BUTTON)
            pick(event, view);
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

TreeId ForestHandler::getTree() const {
    return _state->watched ? _state->watched->id() : noTree;
}

unsigned ForestHandler::getUnit() const {
    return _state->unit;
}

bool ForestHandler::handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action) {
    osg::View* view = action.asView();
    bool handled = false;
    if (!event.getHandled() && view && _state->controls.forest())
        _state->guard.run("a key, a click or the panel has no effect",
                          [&] { handled = _state->handle(event, *view); });
    return handled;
}

void ForestHandler::getUsage(osg::ApplicationUsage& usage) const {
    forEachKey([&](const char* name, const char* does) {
        usage.addKeyboardMouseBinding(std::string("Forest: ") + name, does);
    });
}

} // namespace osgTreeWind
