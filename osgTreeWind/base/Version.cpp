// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Version.h>

#include <string_view>

#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)
#define HEADER_VERSION                                                                                       \
    TEXT(OSGTREEWIND_VERSION_MAJOR)                                                                          \
    "." TEXT(OSGTREEWIND_VERSION_MINOR) "." TEXT(OSGTREEWIND_VERSION_PATCH)

static_assert(std::string_view(HEADER_VERSION) == OSGTREEWIND_PROJECT_VERSION,
              "Version.h and project() in CMakeLists.txt differ");

const char* osgTreeWind::libraryVersion() {
    return HEADER_VERSION;
}
