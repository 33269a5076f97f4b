// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Sets whether value() of a failed Result stops the program, as it does in our own tool and tests. In the
/// program of a host it does not.
void stopAtBadAccess(bool stops = true);

} // namespace osgTreeWind
