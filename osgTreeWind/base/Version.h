// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

/// The version of these headers (CONTRIBUTING.md, Versions).
#define OSGTREEWIND_VERSION_MAJOR 2
#define OSGTREEWIND_VERSION_MINOR 0 ///< MAJOR.MINOR is the library's SOVERSION.
#define OSGTREEWIND_VERSION_PATCH 0 ///< Patch releases do not change the API.

/// Whether these headers have at least that version.
#define OSGTREEWIND_VERSION_AT_LEAST(major, minor, patch)                                                    \
    (OSGTREEWIND_VERSION_MAJOR > (major) ||                                                                  \
     (OSGTREEWIND_VERSION_MAJOR == (major) &&                                                                \
      (OSGTREEWIND_VERSION_MINOR > (minor) ||                                                                \
       (OSGTREEWIND_VERSION_MINOR == (minor) && OSGTREEWIND_VERSION_PATCH >= (patch)))))

namespace osgTreeWind {

/// The version of the loaded library, such as "2.0.0".
OSGTREEWIND_EXPORT const char* libraryVersion();

} // namespace osgTreeWind
