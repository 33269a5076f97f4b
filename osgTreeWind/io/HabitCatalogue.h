// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/TreeHabit.h>

#include <map>
#include <string>

namespace osgTreeWind {

/// The built-in habits (osgTreeWind/growth/habits.treewind) by foldedName(). Any thread.
const std::map<std::string, TreeHabit>& builtInHabits();

} // namespace osgTreeWind
