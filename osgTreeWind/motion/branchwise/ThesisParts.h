// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

// What parts of a tree are to the laws of the thesis. Not for installed headers, as Laws.h.

/// A branch unit (§3.1): a cantilever as wide and as thick as the mean diameter of the scaled unit.
Laws::ThesisBranch makeThesisBranch(const BranchUnit& unit, const TreeScale& scale, const Species& species);

Laws::ThesisLeaf makeThesisLeaf(const LeafMotion& motion);

} // namespace osgTreeWind
