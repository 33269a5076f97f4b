// SPDX-License-Identifier: MIT
#pragma once

#include <tests/io/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

/// A GeoJSON document of features. @param crs empty: WGS 84 in degrees.
inline std::string geoJson(const std::string& features, const std::string& crs = "") {
    return "{\"type\": \"FeatureCollection\"," +
           (crs.empty() ? "" : R"("crs": {"type": "name", "properties": {"name": ")" + crs + "\"}},") +
           "\"features\": [" + features + "]}";
}

inline std::string feature(const std::string& geometry, const std::string& properties = "") {
    return R"({"type": "Feature", "properties": {)" + properties + R"(}, "geometry": )" + geometry + "}";
}

inline std::string point(const std::string& coordinates, const std::string& properties = "") {
    return feature(R"({"type": "Point", "coordinates": [)" + coordinates + "]}", properties);
}

/// Whether an independent program, of Debian's proj-bin or gdal-bin, is installed.
inline bool hasProgram(const std::string& name) {
    return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

#define REQUIRE_PROGRAM(name)                                                                                \
    if (!hasProgram(name))                                                                                   \
    GTEST_SKIP() << (name) << " is not installed: script/bootstrap test"

/// Converts a file in a folder with ogr2ogr. The extension of `to` selects the format.
inline void convert(const TemporaryFolder& folder, const std::string& file, const std::string& to,
                    const std::string& options = "") {
    const std::string command = "cd " + folder.path() + " && ogr2ogr -q " + options + ' ' + to + ' ' + file;
    ASSERT_EQ(std::system((command + " 2>&1").c_str()), 0) << command;
}
