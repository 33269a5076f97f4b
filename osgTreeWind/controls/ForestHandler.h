// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/forest/TreeId.h>

#include <osgGA/GUIEventHandler>

#include <memory>
#include <optional>

namespace osgTreeWind {

class Forest;

/// An event handler that lets a user control a forest by keys: wind, season, law and clock. A click selects a
/// tree and shows its data. `h` lists the keys (docs/view.md). Add the handler to the viewer, and its overlay
/// to the root of the scene, not below a transform:
///
///     osg::ref_ptr<ForestHandler> handler = new ForestHandler(forest);
///     viewer.addEventHandler(handler);
///     root->addChild(handler->getOverlay());
///     while (!viewer.done())
///         viewer.frame(handler->simulationTime(viewer.elapsedTime()));
///
/// A handler serves one viewer and one forest. Call its functions in the event traversal or between frames.
class OSGTREEWIND_EXPORT ForestHandler : public osgGA::GUIEventHandler {
public:
    /// @param forest not referenced. If it is null or was deleted, the handler has no effect.
    explicit ForestHandler(Forest* forest);

    /// A camera that draws the status text over the scene.
    osg::Node* getOverlay() const;
    /// The simulation time to pass to viewer.frame(), with the user's pauses, steps and clock rate. A host
    /// with its own clock does not need it. @param referenceTime the host's time, seconds; values that are
    /// not finite or beyond 1e15 are ignored.
    double simulationTime(double referenceTime);

    std::optional<TreeId> getTree() const; ///< The selected tree; none after a click beside all trees.
    /// The clicked branch unit of the selected tree, for Forest::branch().
    unsigned getUnit() const;

    using osgGA::GUIEventHandler::handle;
    /// osgGA::GUIEventHandler: handles keys and clicks, and updates the overlay in each frame.
    bool handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action) override;
    /// osgGA::GUIEventHandler: adds the keys, for `--help-keys`.
    void getUsage(osg::ApplicationUsage& usage) const override;

protected:
    ~ForestHandler() override;

private:
    class State;
    std::unique_ptr<State> _state;
};

} // namespace osgTreeWind
