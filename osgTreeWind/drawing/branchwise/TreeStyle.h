// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/species/Species.h>

#include <osg/Program>
#include <osg/StateSet>

namespace osgTreeWind {

/// State that many trees share: no tree that is released takes it along. Its owner calls releaseShared().
class SharedStateSet : public osg::StateSet {
public:
    SharedStateSet() = default;
    explicit SharedStateSet(const osg::StateSet& other) : osg::StateSet(other) {}
    SharedStateSet(const SharedStateSet& other) : SharedStateSet(static_cast<const osg::StateSet&>(other)) {}
    void releaseGLObjects(osg::State*) const override {}
    void releaseShared(osg::State* state) const { osg::StateSet::releaseGLObjects(state); }
};

/// How the trees of a species look.
struct TreeStyle {
    osg::ref_ptr<SharedStateSet> bark;        ///< Of a whole tree, posed by the shader.
    osg::ref_ptr<SharedStateSet> branchBark;  ///< Of one unit, posed by the BranchTransform above it.
    osg::ref_ptr<SharedStateSet> leaves;      ///< Of a whole tree, posed by the shader.
    osg::ref_ptr<SharedStateSet> leafCluster; ///< Of one cluster, posed by the transforms above it.
    osg::ref_ptr<SharedStateSet> bareCluster; ///< The same without its leaves.

    /// Colours of a season, for all that share this style. Not during a traversal.
    void showSeason(const Appearance& appearance, float season) const;

    /// Of one context, or of all.
    void releaseGLObjects(osg::State* state) const;
};

/// State sets of their own, with programs and textures that others share.
TreeStyle makeTreeStyle(const Appearance& appearance);

} // namespace osgTreeWind
