// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>

#include <osg/Group>

/// Makes the trees of a forest with osgAnimation, for comparison: one rig per tree, one bone per unit, bark
/// and leaves skinned with one bone per vertex. The bones play a motion recorded under the law `modal`, so
/// computing the motion is not measured. Leaves do not flutter. Light, textures and colours are those of a
/// Forest.
/// @param forest all trees must use model 0. @param hardware true: skinned by a vertex shader; false: by the
/// CPU.
osg::ref_ptr<osg::Group> createRiggedTrees(const osgTreeWind::PlacedForest& forest, bool hardware);
