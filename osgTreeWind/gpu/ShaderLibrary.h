// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Program>

#include <string>

namespace osgTreeWind {

/// The text of a shader: the file `name` in a folder of OSG_FILE_PATH if there is one, else the embedded
/// copy. Lines `#include "other"` are replaced by that shader's text. An unknown name gives an empty text and
/// an OSG_WARN. Thread-safe.
std::string shaderText(const std::string& name);

/// Where the vertex attributes of an instance are: above those that stand for gl_Vertex and the like.
constexpr unsigned treePlaceLocation = 12, treeSizeLocation = 13, treeStateLocation = 14;

/// A program of the shaders `vertex`.vert and `fragment`.frag. Where a file of OSG_FILE_PATH keeps it from
/// compiling or linking, OSG prints the driver's log, and the embedded texts take over after one OSG_WARN.
osg::ref_ptr<osg::Program> createProgram(const std::string& vertex, const std::string& fragment);

} // namespace osgTreeWind
