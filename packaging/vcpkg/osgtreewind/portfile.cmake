# SPDX-License-Identifier: MIT
# An overlay port that builds the checkout that contains it.
#   vcpkg install osgtreewind --overlay-ports=packaging/vcpkg --triplet x64-linux-dynamic
# On Windows, use --triplet x64-windows. That has not been run (docs/windows.md).
vcpkg_check_linkage(ONLY_DYNAMIC_LIBRARY) # plugins and programs must share one library
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS features FEATURES
    matlab OSGTREEWIND_MATIO
    tool OSGTREEWIND_BUILD_TOOL)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS ${features}
    -DCMAKE_INSTALL_LIBDIR=lib
    -DOSGTREEWIND_BUILD_BENCHMARKS=OFF
    -DOSGTREEWIND_BUILD_EXAMPLES=OFF
    -DOSGTREEWIND_BUILD_TESTS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME osgTreeWind CONFIG_PATH lib/cmake/osgTreeWind)
vcpkg_fixup_pkgconfig()
if("tool" IN_LIST FEATURES)
    vcpkg_copy_tools(TOOL_NAMES osgtreewind AUTO_CLEAN)
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
