// SPDX-License-Identifier: MIT
#pragma once

#include "Daylight.h"

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Group>

enum class Shadows {
    Off,
    Soft, ///< A silhouette of each tree on the ground (GroundShadows.h), which leans with it.
    On,   ///< Those of osgShadow, which move with the trees and fall on them too.
};

/// Sky, sun, haze and grassland around a forest.
osg::ref_ptr<osg::Group> createSetting(osgTreeWind::Forest& forest, Shadows shadows = Shadows::Soft,
                                       const Daylight& day = Daylight());
