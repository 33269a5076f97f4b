// SPDX-License-Identifier: MIT
#pragma once

#include <tests/nodes/ForestFixtures.h>

/// The same trees under a law of a branch.
inline osgTreeWind::ForestDescription branchwise(osgTreeWind::ForestDescription description) {
    description.law = osgTreeWind::MotionLaw::ThesisSmooth;
    return description;
}
