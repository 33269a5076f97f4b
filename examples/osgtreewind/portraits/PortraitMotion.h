// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

#include <vector>

/// Flicker in pictures of a moving tree: 960 x 720 pixels, 40 degrees, 4 samples per pixel.
struct PortraitMotion {
    /// Change of luminance from one frame to the next (root mean square; 1/30 s, wind of 2 m/s, 40 m away)
    /// divided by the same change with 64 samples per pixel. 1 means that all change is motion.
    double flicker = 0.0;
    /// Change from one tier of detail to the next, as shares of the pixels around the tree whose luminance
    /// differs by more than 16 of 255.
    struct Pop {
        double pixels; ///< Height of the tree on the screen.
        double apart;  ///< Difference between the two tiers.
        double pop;    ///< Largest change in one frame when approaching at 2 m/s.
    };
    std::vector<Pop> pops;
};

/// Draws and measures the first shape of a species. Throws CommandError if there is no OpenGL context.
PortraitMotion measureMotion(const osgTreeWind::Species& species);
