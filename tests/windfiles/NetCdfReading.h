// SPDX-License-Identifier: MIT
#pragma once

#include <tests/Folders.h>
#include <tests/Near.h>
#include <tests/base/FirstProblem.h>
#include <tests/windfiles/Notes.h>

#include <osgTreeWind/windfiles/WindFile.h>

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace osgTreeWind {

/// Reads a file with `origin` as the scene's origin.
inline Result<WindFile> readAt(const std::string& path, const glm::dvec3& origin = glm::dvec3(0.0),
                               bool asStored = false) {
    WindFileOptions options;
    options.origin = origin;
    options.asStored = asStored;
    return readWindFile(path, options);
}

inline std::string smallNetCdf(const std::string& name) {
    return OSGTREEWIND_TEST_DATA "/wind/" + name;
}

inline std::string fileBytes(const std::string& path) {
    std::ifstream input(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(input), {}};
}

/// Replaces every `from` by a `to` of the same length.
inline std::string renamed(std::string bytes, const std::string& from, const std::string& to) {
    EXPECT_EQ(from.size(), to.size());
    EXPECT_NE(bytes.find(from), std::string::npos) << from;
    for (std::size_t at = 0; (at = bytes.find(from, at)) != std::string::npos; at += to.size())
        bytes.replace(at, to.size(), to);
    return bytes;
}

/// Sets an integer attribute of a classic file to a value below 256.
inline std::string withAttribute(std::string bytes, const std::string& name, int value) {
    const std::size_t at = bytes.find(name);
    EXPECT_NE(at, std::string::npos) << name;
    bytes[at + (name.size() + 3) / 4 * 4 + 11] = static_cast<char>(value); // type, count, value
    return bytes;
}

} // namespace osgTreeWind

/// Skips the test if the library was built without GDAL.
#define REQUIRE_NETCDF(path)                                                                                 \
    if (firstProblem(osgTreeWind::readWindFile(path)).find("NetCDF needs GDAL") != std::string::npos)        \
    GTEST_SKIP() << "built without GDAL"
