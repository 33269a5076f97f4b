// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Transform>

#include <atomic>

namespace osgTreeWind {

/// The transform of a node in its scene, and whether a Switch or LOD hides it. Paths begin at the root.
class ScenePlace {
public:
    void update(const osg::NodePath& path) { _toScene = osg::computeLocalToWorld(path); }
    /// From the node's coordinates to those of the scene's root.
    const osg::Matrix& toScene() const { return _toScene; }
    /// Whether a path has another transform than the path of update(). Returns true only the first time.
    bool isNewSecondPlace(const osg::NodePath& path);

    /// Records that a cull traversal reached the node. Any thread.
    void setCulledFrame(unsigned frame) { _culledFrame = frame; }
    /// Whether a Switch above the node is off, or a LOD above it has not shown it for two frames. Update
    /// visitors reach the node in both cases.
    bool isHidden(const osg::NodePath& path, unsigned frame) const;

private:
    osg::Matrix _toScene;
    std::atomic<unsigned> _culledFrame{~0u};
    bool _hasSecondPlace = false;
};

} // namespace osgTreeWind
