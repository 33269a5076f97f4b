// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/BadAccess.h>

namespace {

/// A test must not go on with the default value of a failed Result.
[[maybe_unused]] const bool stops = (osgTreeWind::stopAtBadAccess(), true);

} // namespace
