# SPDX-License-Identifier: MIT
# Debian packages (`cpack -G DEB` in the build folder, or script/package), one per component, and a tarball
# (`cpack -G TGZ`).
set(soname ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_COMPONENTS_ALL library development plugin tool documentation)
if(osgTreeWind_linkage STREQUAL "STATIC")
    list(REMOVE_ITEM CPACK_COMPONENTS_ALL plugin) # part of development
endif()
set(CPACK_PACKAGE_CONTACT "osgTreeWind maintainers <maintainers@osgtreewind.example>")
set(CPACK_PACKAGE_VENDOR "osgTreeWind")
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/DebianTree.cmake)

function(debian_package component name section summary)
    string(TOUPPER ${component} upper)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
    string(JOIN "\n" text ${ARGN})
    set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${about}\n\n${text}" PARENT_SCOPE)
endfunction()
string(JOIN "\n" about "osgTreeWind is a node kit for OpenSceneGraph that moves every branch and leaf"
    "of whole forests in a given wind: measured, simulated, or streamed.")
debian_package(library libosgtreewind${soname} libs "forests in a given wind for OpenSceneGraph, library"
    "This is the shared library, with the programs that read NetCDF and GRIB for it.")
debian_package(development libosgtreewind-dev libdevel "forests in a given wind for OpenSceneGraph, development"
    "These are the headers, the CMake package, the pkg-config file and the shaders," "which can be replaced.")
debian_package(plugin osgtreewind-plugin libs "forests in a given wind for OpenSceneGraph, plugins"
    "With these plugins, osgviewer and other programs of OpenSceneGraph read and" "write .treewind files.")
debian_package(tool osgtreewind graphics "forests in a given wind for OpenSceneGraph, command-line tool"
    "The tool shows, renders, simulates and measures forests, cuts them into tiled" "worlds, and computes in which winds trees fall.")
debian_package(documentation osgtreewind-doc doc "forests in a given wind for OpenSceneGraph, documentation"
    "This is the documentation.")
set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS library)
set(CPACK_COMPONENT_PLUGIN_DEPENDS library)
set(CPACK_COMPONENT_TOOL_DEPENDS library) # for the programs that read formats
file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/debian/triggers)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libopenscenegraph-dev, libglm-dev")
if(osgTreeWind_linkage STREQUAL "STATIC")
    string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
        ", libtomlplusplus-dev, libpugixml-dev, libcsv-dev, zlib1g-dev, libsqlite3-dev, libutf8proc-dev, libopengl-dev, pkg-config")
endif()
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS osgtreewind-plugin)
set(CPACK_DEBIAN_TOOL_PACKAGE_RECOMMENDS "ffmpeg, osgtreewind-plugin")
set(CPACK_DEBIAN_TOOL_PACKAGE_SUGGESTS osgtreewind-doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
include(CPack)
