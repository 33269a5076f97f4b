// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

#include <string>

/// Writes a picture in the format of the file extension. Throws CommandError on failure.
/// @param options for OSG's writer, such as "PNG_COMPRESSION 1".
void writePicture(const osg::Image& picture, const std::string& path, const std::string& options = {});
