// SPDX-License-Identifier: MIT
#pragma once

#include <tests/EnvironmentVariable.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>

/// Expects the errors of reading a file with a missing reader program, and with one that writes nothing.
/// @param variable environment variable that names the program. @param problem reads the file.
inline void expectMissingReaderError(const char* variable, const std::string& path, const std::string& format,
                                     const std::string& library,
                                     const std::function<std::string()>& problem) {
    const std::string reader = path + ".missing";
    const EnvironmentVariable missing(variable, reader.c_str());
    EXPECT_EQ(problem(), path + ": " + format + " needs " + library + ", and the program " + reader +
                             ": No such file or directory");
#ifndef _WIN32 // which has no program that does nothing
    const EnvironmentVariable silent(variable, "/bin/true");
    EXPECT_EQ(problem(), path + ": the " + format + " file is damaged: its reader ended with status 0");
#endif
}
