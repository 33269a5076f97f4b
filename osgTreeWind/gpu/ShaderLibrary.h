// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Program>
#include <osg/StateSet>

#include <string>

namespace osgTreeWind {

/// The text of a shader: the file `name` in a folder of OSG_FILE_PATH if there is one, else the embedded
/// copy. Lines `#include "other"` are replaced by that shader's text. An unknown name gives an empty text and
/// an OSG_WARN. Thread-safe.
std::string shaderText(const std::string& name);

/// Where the vertex attributes of an instance are: above those that stand for gl_Vertex and the like.
constexpr unsigned treePlaceLocation = 12, treeSizeLocation = 13, treeStateLocation = 14,
                   treeLightLocation = 15;

/// How programs of ours are set: without them trees are where nobody expects them, so that a program which a
/// host sets with OVERRIDE above a forest leaves them alone. One that is set below replaces them.
constexpr auto ownProgram = osg::StateAttribute::ON | osg::StateAttribute::PROTECTED;

/// Neither side is left out: by default OSG's shadow cameras draw back faces alone, and override what is not
/// PROTECTED.
inline void drawBothSides(osg::StateSet& state) {
    state.setMode(GL_CULL_FACE, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
}

/// Whether programs of ours run in the context that is current: `#version 330 compatibility` does not in a
/// core profile. The first time it says no it says so, by an OSG_WARN, and why.
bool canRunPrograms(const osg::State& state);

/// A program of the shaders `vertex`.vert and `fragment`.frag: the same one for all who hold it, for as long
/// as their texts are the same; any thread. Where a file of OSG_FILE_PATH keeps it from
/// compiling or linking, OSG prints the driver's log, and the embedded texts take over after one OSG_WARN.
/// It leaves a context alone where canRunPrograms() says no.
osg::ref_ptr<osg::Program> sharedProgram(const std::string& vertex, const std::string& fragment);

} // namespace osgTreeWind
