# SPDX-License-Identifier: MIT
# Options of all targets.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release)
endif()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
# Windows finds a DLL beside the program, and OSG its plugins in a folder there.
set(module_folder lib)
set(module_destination ${CMAKE_INSTALL_LIBDIR})
if(WIN32)
    set(module_folder bin)
    set(module_destination ${CMAKE_INSTALL_BINDIR})
endif()
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${module_folder})
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# One seed gives one tree and one motion, bit for bit, on all processors: no fused multiply-add, and no vectors in Eigen,
# whose versions add up the elements of a vector in different orders.
add_compile_definitions(EIGEN_DONT_VECTORIZE)
if(MSVC)
    add_compile_options(/fp:precise /utf-8)
else()
    add_compile_options(-ffp-contract=off)
endif()
if(MINGW)
    # A unity build has more sections than the usual object files may have. GCC aligns no stack to the 32 bytes of AVX on
    # Windows (its bug 54412).
    add_compile_options(-Wa,-mbig-obj,-muse-unaligned-vector-move)
endif()

set(OSGTREEWIND_SANITIZE "" CACHE STRING "Sanitizers for every target, e.g. address,undefined or thread")
if(OSGTREEWIND_SANITIZE)
    add_compile_options(-fsanitize=${OSGTREEWIND_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${OSGTREEWIND_SANITIZE})
    add_compile_definitions(_GLIBCXX_ASSERTIONS) # e.g. an empty std::optional has no value
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        add_compile_options(-Wno-maybe-uninitialized) # false positives of GCC 12 in std::function
    endif()
endif()

# Other compilers than those of Debian 12 may have new warnings; these never stop a build.
option(OSGTREEWIND_WARNINGS_AS_ERRORS "Treat warnings of GCC 12 and clang 14 as errors" OFF)
string(REGEX MATCH "^[0-9]+" compiler_major ${CMAKE_CXX_COMPILER_VERSION})
if(OSGTREEWIND_WARNINGS_AS_ERRORS AND "${CMAKE_CXX_COMPILER_ID} ${compiler_major}" MATCHES "^(GNU 12|Clang 14)$")
    set(CMAKE_COMPILE_WARNING_AS_ERROR ON)
endif()
add_library(osgTreeWind_warnings INTERFACE)
if(MSVC)
    target_compile_options(osgTreeWind_warnings INTERFACE /W4)
    target_compile_definitions(osgTreeWind_warnings INTERFACE _USE_MATH_DEFINES NOMINMAX _CRT_SECURE_NO_WARNINGS)
else()
    target_compile_options(osgTreeWind_warnings INTERFACE -Wall -Wextra -Wpedantic)
endif()
