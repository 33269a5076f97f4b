// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/LeafOrders.h>
#include <osgTreeWind/drawing/instanced/TreeTiers.h>
#include <osgTreeWind/drawing/looks/LeafStencils.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/species/Appearance.h>

#include <osg/Geometry>
#include <osg/StateSet>

namespace osgTreeWind {

/// The geometry of a model at each tier with branches. It does not change once it is made.
struct ModelMeshes : osg::Referenced {
    ModelMeshes(const TreeModel& model, const Appearance& appearance);

    osg::ref_ptr<osg::Geometry> bark[branchTiers];
    LeafOrders::Geometries leaves[branchTiers];      ///< Null in a tree without leaves.
    osg::ref_ptr<osg::StateSet> states[branchTiers]; ///< Where shaders find poses, and how bright leaves are.
    LeafStencils::Atlas stencils;                    ///< Held for the next one, and for pictures.
};

/// The meshes of a model: the same ones for all in the process who hold them, where the model is shared
/// (TreeModel::identity). Any thread.
osg::ref_ptr<ModelMeshes> sharedMeshes(const TreeModel& model, const Appearance& appearance);

} // namespace osgTreeWind
