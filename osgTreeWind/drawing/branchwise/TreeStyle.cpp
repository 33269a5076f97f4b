// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/TreeStyle.h>

#include <osgTreeWind/drawing/looks/SceneShading.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/species/Season.h>

namespace osgTreeWind {

TreeStyle TreeStyles::style(const Appearance& appearance) {
    if (!_barkProgram) {
        _barkProgram = createProgram("branchwise/bark", "bark");
        _leafProgram = createProgram("branchwise/leaf", "leaf");
    }
    TreeStyle style{new SharedStateSet, nullptr, new SharedStateSet, nullptr, nullptr};
    style.bark->setAttributeAndModes(_barkProgram);
    style.bark->setTextureAttribute(0, _textures.bark(appearance));
    style.bark->addUniform(new osg::Uniform("barkTexture", 0));
    style.bark->addUniform(new osg::Uniform("barkColor", toOsg(appearance.bark)));
    style.bark->setMode(GL_CULL_FACE, osg::StateAttribute::OFF); // joints are open tubes

    style.branchBark = new SharedStateSet(*style.bark);
    style.branchBark->addUniform(new osg::Uniform("treeFirstUnit", -1));

    style.leaves->setAttributeAndModes(_leafProgram);
    style.leaves->setTextureAttribute(0, _textures.leaves(appearance));
    style.leaves->addUniform(new osg::Uniform("leafTexture", 0));
    style.leaves->addUniform(new osg::Uniform("leafColor", toOsg(appearance.leaves)));
    style.leaves->addUniform(new osg::Uniform("twigColor", toOsg(appearance.twigs())));
    // Shadow cameras would leave out half of them.
    style.leaves->setMode(GL_CULL_FACE, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
    setCoverageModes(*style.leaves);
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
    leaves->getUniform("leafColor")->set(toOsg(leafColor(appearance, season))); // which all of them share
}

void TreeStyle::releaseGLObjects(osg::State* state) const {
    for (const osg::ref_ptr<SharedStateSet>& shared : {bark, branchBark, leaves, leafCluster, bareCluster})
        shared->releaseShared(state);
}

} // namespace osgTreeWind
