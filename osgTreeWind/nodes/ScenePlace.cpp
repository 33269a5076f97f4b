// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/ScenePlace.h>

#include <osg/LOD>
#include <osg/Switch>

#include <utility>

namespace osgTreeWind {

namespace {

constexpr unsigned maxUnseenFrames = 2; // below a LOD

} // namespace

bool ScenePlace::isNewSecondPlace(const osg::NodePath& path) {
    return !_hasSecondPlace && osg::computeLocalToWorld(path) != _toScene &&
           !std::exchange(_hasSecondPlace, true);
}

bool ScenePlace::isHidden(const osg::NodePath& path, unsigned frame) const {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (auto* choice = dynamic_cast<osg::Switch*>(path[i]))
            if (!choice->getChildValue(path[i + 1]))
                return true;
        if (dynamic_cast<osg::LOD*>(path[i]) && _culledFrame != ~0u && frame > _culledFrame + maxUnseenFrames)
            return true;
    }
    return false;
}

} // namespace osgTreeWind
