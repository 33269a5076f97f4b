// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/branchwise/TreeStyle.h>

#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/nodes/TreeTextures.h>

namespace osgTreeWind {
namespace {

osg::ref_ptr<osg::Texture2D> createTexture(const char* name, osg::Image* image, osg::Texture::WrapMode wrap) {
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setName(name);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, wrap);
    return texture;
}

} // namespace

TreeStyles::TreeStyles()
    : _barkProgram(createProgram("branchwise/bark", "bark")),
      _leafProgram(createProgram("branchwise/leaf", "leaf")),
      _bark(createTexture("bark", barkImage(), osg::Texture::REPEAT)),
      _blades(createTexture("blades", bladeImage(), osg::Texture::CLAMP_TO_EDGE)),
      _needles(createTexture("needles", needleImage(), osg::Texture::CLAMP_TO_EDGE)) {}

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
