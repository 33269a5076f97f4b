// SPDX-License-Identifier: MIT
// What the C++ of README.md takes for granted.
#include <osgTreeWind/drawing/BranchTransform.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/species/Season.h>
#include <osgTreeWind/wind/StreamedWind.h>

osgTreeWind::ForestDescription describeForest();

void embed(osg::Group* scene, const osgTreeWind::GridWind::Grid& grid, const std::vector<float>& velocities,
           osg::Node* sensor, const osgTreeWind::TreePlacement& placement) {
#include "readme.inc"
}
