// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/scanfiles/ScanFile.h>

namespace osgTreeWind {

/// Has Wire pass trees from the process that reads them.
inline bool passMembers(Wire& wire, ScanFile& scan) {
    return wire.pass(scan.format, scan.trees);
}

} // namespace osgTreeWind
