// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>

#include <osg/Group>

/// The trees of a forest as users of OSG have them today: a rig of osgAnimation each, a bone a unit, bark and
/// leaves skinned with one bone a vertex. A motion that was recorded under the law `modal` plays on the
/// bones; what works it out is not counted, and leaves do not flutter. Lit, textured and coloured as the
/// trees of a Forest.
/// @param forest all of its trees are of model 0. @param hardware skinned by a vertex shader, else by the
/// CPU.
osg::ref_ptr<osg::Group> createRiggedTrees(const osgTreeWind::PlacedForest& forest, bool hardware);
