// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

// Parameters of the laws of the thesis. Not for installed headers, as Laws.h.

/// A branch unit (§3.1): a cantilever with the mean diameter of the scaled unit as its width and thickness.
Laws::ThesisBranch makeThesisBranch(const BranchUnit& unit, const TreeScale& scale, const Species& species);

Laws::ThesisLeaf makeThesisLeaf(const LeafMotion& motion);

} // namespace osgTreeWind
