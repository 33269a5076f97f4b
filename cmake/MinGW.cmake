# SPDX-License-Identifier: MIT
# Toolchain file: 64-bit Windows by Debian's MinGW-w64, with the libraries of the folder OSGTREEWIND_WINDOWS_ROOT (a CMake or
# environment variable), which script/windows builds. Programs of the build run under Wine.
if(NOT DEFINED OSGTREEWIND_WINDOWS_ROOT)
    set(OSGTREEWIND_WINDOWS_ROOT $ENV{OSGTREEWIND_WINDOWS_ROOT})
endif()
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES OSGTREEWIND_WINDOWS_ROOT)

set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_VERSION 10.0) # OSG and other projects make _WIN32_WINNT of it
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(mingw x86_64-w64-mingw32)
set(CMAKE_C_COMPILER ${mingw}-gcc-posix) # the variant with std::thread
set(CMAKE_CXX_COMPILER ${mingw}-g++-posix)
set(CMAKE_RC_COMPILER ${mingw}-windres)
set(CMAKE_CROSSCOMPILING_EMULATOR wine)

list(APPEND CMAKE_FIND_ROOT_PATH ${OSGTREEWIND_WINDOWS_ROOT} /usr/${mingw}) # after those of the user
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# pkg-config finds nothing of the host.
set(ENV{PKG_CONFIG_LIBDIR} ${OSGTREEWIND_WINDOWS_ROOT}/lib/pkgconfig:/usr/${mingw}/lib/pkgconfig)
set(ENV{PKG_CONFIG_PATH} "")
