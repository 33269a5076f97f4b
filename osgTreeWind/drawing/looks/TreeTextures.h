// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/species/Species.h>

#include <osg/Image>
#include <osg/Program>
#include <osg/StateSet>
#include <osg/Texture2D>

#include <vector>

namespace osgTreeWind {

// Images are painted, or read from the user's cache or a file, by any thread. They are shared while held; do
// not modify them.

/// The leaf texture of an appearance, with a name of its content: layout of LeafAtlas.h, channels of
/// LeafTexels.h.
osg::ref_ptr<osg::Image> leafImage(const Appearance& appearance);
/// The bark texture of an appearance, with the channels of BarkRelief.h. It repeats along the branch and
/// twice around it; images from files are mirrored.
osg::ref_ptr<osg::Image> barkImage(const Appearance& appearance);

/// A texture of leafImage(), shared while it is in use. Any thread.
osg::ref_ptr<osg::Texture2D> leafTexture(const Appearance& appearance);
/// A texture of barkImage(), shared while it is in use. Any thread.
osg::ref_ptr<osg::Texture2D> barkTexture(const Appearance& appearance);
/// The leaf and bark textures of species, several painted at once.
std::vector<osg::ref_ptr<osg::Texture2D>> treeTextures(const std::vector<Species>& species,
                                                       const Executor& executor);

/// Sets program, texture and uniforms for drawing bark.
void configureBark(osg::StateSet& state, osg::Program* program, const Appearance& appearance);
/// Sets program, texture and uniforms for drawing leaves and twigs, except the leaf colour.
void configureLeaves(osg::StateSet& state, osg::Program* program, const Appearance& appearance);

} // namespace osgTreeWind
