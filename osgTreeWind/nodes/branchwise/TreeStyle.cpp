// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/branchwise/TreeStyle.h>

#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/nodes/TreeTextures.h>

namespace osgTreeWind {
TreeStyles::TreeStyles()
    : _barkProgram(createProgram("branchwise/bark", "bark")),
      _leafProgram(createProgram("branchwise/leaf", "leaf")),
      _bark(makeTreeTexture("bark", barkImage(), osg::Texture::REPEAT)),
      _blades(makeTreeTexture("blades", bladeImage(), osg::Texture::CLAMP_TO_EDGE)),
      _needles(makeTreeTexture("needles", needleImage(), osg::Texture::CLAMP_TO_EDGE)) {}

TreeStyle TreeStyles::style(const Appearance& appearance) const {
    TreeStyle style{new osg::StateSet, nullptr, new osg::StateSet, nullptr};
    style.bark->setAttributeAndModes(_barkProgram);
    style.bark->setTextureAttribute(0, _bark);
    style.bark->addUniform(new osg::Uniform("barkTexture", 0));
    style.bark->addUniform(new osg::Uniform("barkColor", toOsg(appearance.bark)));
    style.bark->setMode(GL_CULL_FACE, osg::StateAttribute::OFF); // joints are open tubes

    style.branchBark = new osg::StateSet(*style.bark);
    style.branchBark->addUniform(new osg::Uniform("treeFirstUnit", -1));

    style.leaves->setAttributeAndModes(_leafProgram);
    style.leaves->setTextureAttribute(0, appearance.needles ? _needles : _blades);
    style.leaves->addUniform(new osg::Uniform("leafTexture", 0));
    style.leaves->addUniform(new osg::Uniform("leafColor", toOsg(appearance.leaves)));
    style.leaves->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    style.leafCluster = new osg::StateSet(*style.leaves);
    style.leafCluster->addUniform(new osg::Uniform("treeFirstUnit", -1));
    style.leafCluster->addUniform(new osg::Uniform("treeFirstLeaf", -1));
    style.leafCluster->addUniform(new osg::Uniform("treeSizes", osg::Vec2(1.0f, 1.0f)));
    return style;
}

} // namespace osgTreeWind
