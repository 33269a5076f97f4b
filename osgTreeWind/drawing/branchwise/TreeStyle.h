// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/species/Species.h>

#include <osg/Program>
#include <osg/StateSet>

namespace osgTreeWind {

/// A state set that many trees share. Releasing a tree does not release it; its owner calls releaseShared().
class SharedStateSet : public osg::StateSet {
public:
    SharedStateSet() = default;
    explicit SharedStateSet(const osg::StateSet& other) : osg::StateSet(other) {}
    SharedStateSet(const SharedStateSet& other) : SharedStateSet(static_cast<const osg::StateSet&>(other)) {}
    void releaseGLObjects(osg::State*) const override {}
    void releaseShared(osg::State* state) const { osg::StateSet::releaseGLObjects(state); }
};

/// The state sets of the trees of a species under a branchwise law.
struct TreeStyle {
    osg::ref_ptr<SharedStateSet> bark;        ///< Of a whole tree, posed by the shader.
    osg::ref_ptr<SharedStateSet> branchBark;  ///< Of one unit, posed by the BranchTransform above it.
    osg::ref_ptr<SharedStateSet> leaves;      ///< Of a whole tree, posed by the shader.
    osg::ref_ptr<SharedStateSet> leafCluster; ///< Of one cluster, posed by the transforms above it.
    osg::ref_ptr<SharedStateSet> bareCluster; ///< Of one cluster without leaves.

    /// Sets the leaf colour of a season for all copies of this style. Not during a traversal.
    void showSeason(const Appearance& appearance, float season) const;

    /// @param state of one context, or null for all.
    void releaseGLObjects(osg::State* state) const;
};

/// Makes new state sets with shared programs and textures.
TreeStyle makeTreeStyle(const Appearance& appearance);

} // namespace osgTreeWind
