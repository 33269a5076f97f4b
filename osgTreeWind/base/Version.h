// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

/// The version of these headers (CONTRIBUTING.md, Versions).
#define OSGTREEWIND_VERSION_MAJOR 2
#define OSGTREEWIND_VERSION_MINOR 0 ///< With MAJOR it is the library's SOVERSION.
#define OSGTREEWIND_VERSION_PATCH 0 ///< No interface differs by it.

/// Whether these headers are of that version or a later one.
#define OSGTREEWIND_VERSION_AT_LEAST(major, minor, patch)                                                    \
    (OSGTREEWIND_VERSION_MAJOR > (major) ||                                                                  \
     (OSGTREEWIND_VERSION_MAJOR == (major) &&                                                                \
      (OSGTREEWIND_VERSION_MINOR > (minor) ||                                                                \
       (OSGTREEWIND_VERSION_MINOR == (minor) && OSGTREEWIND_VERSION_PATCH >= (patch)))))

namespace osgTreeWind {

/// The version of the library that is loaded, "2.0.0".
OSGTREEWIND_EXPORT const char* libraryVersion();

} // namespace osgTreeWind
