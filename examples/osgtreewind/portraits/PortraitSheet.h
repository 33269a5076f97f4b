// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

#include <osg/Image>

/// What pictures of a portrait are, for --help.
extern const char* const portraitLayout;

/// Draws the sheet of a species. @param openGrown as it grows by itself; else as in a forest, of the sizes
/// that its laws have for its height. @param panel width and height of each picture, pixels. @param season of
/// the whole tree at the lower right. Ends the command where there is no graphics context.
osg::ref_ptr<osg::Image> drawPortrait(const osgTreeWind::Species& species, bool openGrown, int panel,
                                      float season);
