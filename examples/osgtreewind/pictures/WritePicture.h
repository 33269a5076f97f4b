// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

#include <string>

/// Writes a picture as a whole file, in the format of its extension. Ends the command where it cannot.
/// @param options of OSG's writer, as "PNG_COMPRESSION 1".
void writePicture(const osg::Image& picture, const std::string& path, const std::string& options = {});
