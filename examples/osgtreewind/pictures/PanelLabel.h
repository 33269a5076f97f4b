// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

#include <string>

/// Writes a line of ASCII into the upper left corner of an RGB or RGBA picture of bytes, white on a darker
/// strip. Where it does not fit nothing is written.
void writeLabel(osg::Image& picture, const std::string& text);
