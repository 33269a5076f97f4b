// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/forest/TreeId.h>

#include <osgGA/GUIEventHandler>

#include <memory>

namespace osgTreeWind {

class Forest;

/// Keys and mouse by which a person steers a forest in a viewer: wind, season, law, clock; a click says what
/// a tree is and how it sways. `h` shows the keys (docs/view.md). Add it to the viewer, and what it shows to
/// the scene's root, outside of transforms:
///
///     osg::ref_ptr<ForestHandler> handler = new ForestHandler(forest);
///     viewer.addEventHandler(handler);
///     root->addChild(handler->getOverlay());
///     while (!viewer.done())
///         viewer.frame(handler->simulationTime(viewer.elapsedTime()));
///
/// One viewer, which calls it in its event traversal.
class OSGTREEWIND_EXPORT ForestHandler : public osgGA::GUIEventHandler {
public:
    /// Of a forest, which it does not keep; without one, or once that is gone, nothing happens.
    explicit ForestHandler(Forest* forest);

    /// The text over the picture.
    osg::Node* getOverlay() const;
    /// The simulation time of a frame, which may pause, or go faster or slower than a host's own: pass it to
    /// the viewer. A host with a clock of its own does without. @param referenceTime seconds; what is not
    /// within 1e15 changes nothing.
    double simulationTime(double referenceTime);

    /// The tree that was clicked last; noTree: none, or beside all.
    TreeId getTree() const;
    /// Which of its branch units (Forest::branch()).
    unsigned getUnit() const;

    using osgGA::GUIEventHandler::handle;
    /// osgGA::GUIEventHandler: keys, clicks, and a frame's panel.
    bool handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action) override;
    /// osgGA::GUIEventHandler: the keys, for `--help-keys`.
    void getUsage(osg::ApplicationUsage& usage) const override;

protected:
    ~ForestHandler() override;

private:
    class State;
    std::unique_ptr<State> _state;
};

} // namespace osgTreeWind
