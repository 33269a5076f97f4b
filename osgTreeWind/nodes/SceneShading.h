// SPDX-License-Identifier: MIT
#pragma once

#include <osg/StateSet>

#include <osgUtil/CullVisitor>

#include <array>
#include <map>
#include <mutex>

namespace osgTreeWind {

/// What the scene above says of light, for shaders that have no fixed functions to ask: which lights are on,
/// which fog there is, whether osgShadow's ShadowMap or ViewDependentShadowMap hands shadows down. Any
/// thread.
class SceneShading {
public:
    /// State with the defines of shaders/light.glsl and shaders/scene.glsl, as the scene stands where a cull
    /// is.
    osg::ref_ptr<osg::StateSet> stateFor(const osgUtil::CullVisitor& visitor);

private:
    std::mutex _mutex;
    std::map<std::array<int, 6>, osg::ref_ptr<osg::StateSet>> _states; ///< By what they define.
};

} // namespace osgTreeWind
