// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/TreeHabit.h>

#include <variant>
#include <vector>

namespace osgTreeWind {

/// One number of a habit, or one for each order of branching.
struct HabitNumber {
    const char* key; ///< In a file.
    std::variant<float TreeHabit::*, ByOrder TreeHabit::*> member;
    float least, most; ///< In `unit`; of degrees too, though the member is in radians.
    const char* unit;  ///< Empty: none.
    bool whole = false;
};

/// All numbers of a habit, in the order of TreeHabit.h.
const std::vector<HabitNumber>& habitNumbers();

/// Every number within its range; NaN becomes that of a TreeHabit{}.
TreeHabit clampedHabit(TreeHabit habit);

/// Edge of the boxes in which the light of a tree is reckoned, metres.
float gridCell(const TreeHabit& habit);

} // namespace osgTreeWind
