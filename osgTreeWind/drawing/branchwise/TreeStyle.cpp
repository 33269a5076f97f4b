// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/TreeStyle.h>

#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/species/Season.h>

namespace osgTreeWind {

TreeStyle makeTreeStyle(const Appearance& appearance) {
    TreeStyle style{new SharedStateSet, nullptr, new SharedStateSet, nullptr, nullptr};
    configureBark(*style.bark, sharedProgram("branchwise/bark", "bark"), appearance);
    style.branchBark = new SharedStateSet(*style.bark);
    style.branchBark->addUniform(new osg::Uniform("treeFirstUnit", -1));

    configureLeaves(*style.leaves, sharedProgram("branchwise/leaf", "leaf"), appearance);
    style.leaves->addUniform(new osg::Uniform("leafColor", toOsg(appearance.leaves)));
    style.leafCluster = new SharedStateSet(*style.leaves);
    style.leafCluster->addUniform(new osg::Uniform("treeFirstUnit", -1));
    style.leafCluster->addUniform(new osg::Uniform("treeFirstLeaf", -1));
    style.leafCluster->addUniform(new osg::Uniform("treeSizes", osg::Vec2(1.0f, 1.0f)));
    style.bareCluster = new SharedStateSet(*style.leafCluster);
    style.leafCluster->addUniform(new osg::Uniform("treeLeaves", 1.0f));
    style.bareCluster->addUniform(new osg::Uniform("treeLeaves", 0.0f));
    return style;
}

void TreeStyle::showSeason(const Appearance& appearance, float season) const {
    leaves->getUniform("leafColor")
        ->set(toOsg(leafColor(appearance, season))); // shared with leafCluster and bareCluster
}

void TreeStyle::releaseGLObjects(osg::State* state) const {
    for (const osg::ref_ptr<SharedStateSet>& shared : {bark, branchBark, leaves, leafCluster, bareCluster})
        shared->releaseShared(state);
}

} // namespace osgTreeWind
