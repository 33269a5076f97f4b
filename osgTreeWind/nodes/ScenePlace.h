// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Transform>

#include <atomic>

namespace osgTreeWind {

/// Where a node is in its scene, and whether anybody can see it there.
class ScenePlace {
public:
    /// Takes over the place of an update traversal: `path` from the root to the node.
    void update(const osg::NodePath& path) { _toScene = osg::computeLocalToWorld(path); }
    /// From the node to the scene's root.
    const osg::Matrix& toScene() const { return _toScene; }
    /// Whether the node is elsewhere on this path. @return true once.
    bool isSecond(const osg::NodePath& path);

    /// A cull traversal has reached the node. Any thread.
    void culled(unsigned frame) { _culledFrame = frame; }
    /// Whether a Switch or LOD above hides the node, which update visitors enter nevertheless.
    bool isHidden(const osg::NodePath& path, unsigned frame) const;

private:
    osg::Matrix _toScene;
    std::atomic<unsigned> _culledFrame{~0u};
    bool _twoPlaces = false;
};

} // namespace osgTreeWind
