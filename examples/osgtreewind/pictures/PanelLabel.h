// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

#include <string>

/// Writes a line of ASCII into the upper left corner of an 8-bit RGB or RGBA picture, white on a dark strip.
/// Writes nothing if the text does not fit.
void writeLabel(osg::Image& picture, const std::string& text);
