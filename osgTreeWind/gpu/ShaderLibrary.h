// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Program>
#include <osg/StateSet>

#include <string>

namespace osgTreeWind {

/// Returns the text of a shader: of the file `name` in OSG_FILE_PATH if it exists, else the embedded copy.
/// Expands lines `#include "other"`. An unknown name gives an empty text and an OSG_WARN. Thread-safe.
std::string shaderText(const std::string& name);

/// Locations of the vertex attributes of an instance, above those that alias gl_Vertex and its like.
constexpr unsigned treePlaceLocation = 12, treeSizeLocation = 13, treeStateLocation = 14,
                   treeLightLocation = 15;

/// Locations of packed bark (shaders/bark_vertex.glsl).
constexpr unsigned barkPlaceLocation = 10, barkSharesLocation = 11;

/// Attribute value for the library's programs. Trees cannot be drawn without them, so a program that a host
/// sets with OVERRIDE above a forest must not replace them. A program set below the forest does.
constexpr auto protectedProgram = osg::StateAttribute::ON | osg::StateAttribute::PROTECTED;

/// Disables face culling, PROTECTED against OSG's shadow cameras, which draw back faces only.
inline void drawBothSides(osg::StateSet& state) {
    state.setMode(GL_CULL_FACE, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
}

/// Makes shaders apply all clip planes in a core profile, for state without setSceneDefines().
inline void clipByAllPlanes(osg::StateSet& state) {
    state.setDefine("CLIP_PLANES", "8");
}

/// Returns a program of the shaders `vertex`.vert and `fragment`.frag. Calls share one program while their
/// texts are equal and it is referenced. If a file in OSG_FILE_PATH does not compile or link, OSG prints the
/// driver's log, and the embedded shaders replace it after one OSG_WARN. Contexts of both profiles may share
/// the program: each gets shaders of `#version 330` for its own profile (shaders/core.glsl). Any thread.
osg::ref_ptr<osg::Program> sharedProgram(const std::string& vertex, const std::string& fragment);

/// Returns a program of two texts that have no `#version` and use the names of shaders/core.glsl, for
/// contexts of both profiles. Any thread.
osg::ref_ptr<osg::Program> makeProgram(const std::string& name, const std::string& vertexText,
                                       const std::string& fragmentText);

} // namespace osgTreeWind
