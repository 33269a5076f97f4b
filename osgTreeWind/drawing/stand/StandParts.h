// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/stand/StandDrawing.h>
#include <osgTreeWind/drawing/stand/TreeStand.h>

namespace osgTreeWind {

/// What a StandDrawing is made of: for the library's own files and its tests.
struct StandParts {
    /// The one drawable of all trees.
    static TreeStand* trees(const StandDrawing& stand) { return stand._trees.get(); }
};

} // namespace osgTreeWind
