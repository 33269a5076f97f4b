// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Group>

/// Sky, sun and ground around a forest, with a soft shadow under every tree.
osg::ref_ptr<osg::Group> createSetting(osgTreeWind::Forest& forest);
