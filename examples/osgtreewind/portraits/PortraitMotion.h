// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

#include <vector>

/// How restless the picture of a tree is, of 960 x 720 pixels and 40 degrees with 4 samples a pixel.
struct PortraitMotion {
    /// Change of luminance from one frame to the next (root mean square; 1/30 s, wind of 2 m/s, 40 m away)
    /// over that of a picture with 64 samples a pixel: 1 where all of it is motion.
    double flicker = 0.0;
    /// Where one tier of detail gives way to the next: shares of a box about the tree whose luminance differs
    /// by more than 16 of 255.
    struct Pop {
        double pixels; ///< Height on the screen.
        double apart;  ///< Between all of the one tier and all of the next,
        double pop;    ///< and at most from frame to frame as one comes nearer by 2 m/s.
    };
    std::vector<Pop> pops;
};

/// Draws the first shape of a species. Ends the command where there is no graphics context.
PortraitMotion measureMotion(const osgTreeWind::Species& species);
