// SPDX-License-Identifier: MIT
#pragma once

#include <osg/StateSet>

#include <osgUtil/CullVisitor>

#include <map>
#include <mutex>
#include <string>

namespace osgTreeWind {

/// What the scene above says of light, for shaders that have no fixed functions to ask: which lights are on, which fog
/// there is, whether osgShadow's ShadowMap or ViewDependentShadowMap hands shadows down. Any thread.
class SceneShading {
public:
    /// State with the defines of shaders/light.glsl and shaders/scene.glsl, as the scene stands where a cull is.
    osg::ref_ptr<osg::StateSet> stateFor(const osgUtil::CullVisitor& visitor);

private:
    std::mutex _mutex;
    std::map<std::map<std::string, std::string>, osg::ref_ptr<osg::StateSet>> _states; ///< By their defines.
};

} // namespace osgTreeWind
