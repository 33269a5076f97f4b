// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

#include <osg/Image>

/// Layout of the sheet, for --help.
extern const char* const portraitLayout;

/// Draws the sheet of a species. Throws CommandError if there is no OpenGL context.
/// @param openGrown grown in the open; otherwise as in a forest, with the sizes that the species' laws give
/// for its usual height. @param panel width and height of each picture, pixels. @param season season of the
/// last but one picture.
osg::ref_ptr<osg::Image> drawPortrait(const osgTreeWind::Species& species, bool openGrown, int panel,
                                      float season);
