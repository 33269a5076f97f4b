// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <vector>

namespace osgTreeWind {

/// A problem with key "times" unless they are within 1e15 s and strictly increasing; empty when they are.
Diagnostics checkTimes(const std::vector<double>& times);

} // namespace osgTreeWind
