// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/Species.h>

#include <osg/Program>
#include <osg/StateSet>
#include <osg/Texture2D>

namespace osgTreeWind {

/// How the trees of a species look.
struct TreeStyle {
    osg::ref_ptr<osg::StateSet> bark;        ///< Of a whole tree, posed by the shader.
    osg::ref_ptr<osg::StateSet> branchBark;  ///< Of one unit, posed by the BranchTransform above it.
    osg::ref_ptr<osg::StateSet> leaves;      ///< Of a whole tree, posed by the shader.
    osg::ref_ptr<osg::StateSet> leafCluster; ///< Of one cluster, posed by the transforms above it.
};

/// Makes styles that share programs and textures.
class TreeStyles {
public:
    TreeStyles();
    TreeStyle style(const Appearance& appearance) const;

private:
    osg::ref_ptr<osg::Program> _barkProgram, _leafProgram;
    osg::ref_ptr<osg::Texture2D> _bark, _blades, _needles;
};

} // namespace osgTreeWind
