// SPDX-License-Identifier: MIT
#pragma once

#include <tests/nodes/ForestFixtures.h>

/// The same trees under a branchwise law.
inline osgTreeWind::ForestDescription branchwise(osgTreeWind::ForestDescription description) {
    description.law = osgTreeWind::MotionLaw::ThesisSmooth;
    return description;
}
