// SPDX-License-Identifier: MIT
#pragma once

#include <tests/Folders.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

/// Path of a file in the folder of real input (OSGTREEWIND_DATA, by default ../shared/data beside the
/// checkout); empty if it does not exist.
inline std::string realData(const std::string& name) {
    const char* folder = std::getenv("OSGTREEWIND_DATA");
    const std::filesystem::path path =
        std::filesystem::path(folder ? folder : OSGTREEWIND_SOURCE_DIR "/../shared/data") / name;
    return std::filesystem::exists(path) ? path.generic_string() : std::string();
}

/// Skips the running test, with a message, if the file of real input does not exist.
#define REQUIRE_REAL_DATA(variable, name)                                                                    \
    const std::string variable = realData(name);                                                             \
    if (variable.empty())                                                                                    \
    GTEST_SKIP() << "real input " << (name) << " not found; set OSGTREEWIND_DATA"
