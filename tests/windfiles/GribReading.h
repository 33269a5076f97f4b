// SPDX-License-Identifier: MIT
#pragma once

#include <tests/base/FirstProblem.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/windfiles/GribWriting.h>
#include <tests/windfiles/NetCdfReading.h>

#include <osgTreeWind/windfiles/WindFormats.h>

namespace osgTreeWind {

/// Reads the whole of a file with these bytes in its own CRS.
inline Result<WindFile> readGribBytes(const std::string& bytes, bool asStored = true,
                                      const std::vector<std::string>& variable = {}) {
    const TemporaryFolder folder;
    WindFileOptions options;
    options.asStored = asStored;
    options.variable = variable;
    return readWindFile(folder.write("wind.grib", bytes), options);
}

/// The problem of a file with these bytes, without the name of the file.
inline std::string problemOfGrib(const std::string& bytes) {
    const Result<WindFile> file = readGribBytes(bytes);
    const std::string text = firstProblem(file);
    EXPECT_EQ(file.problems().size(), file ? 0u : 1u) << text;
    const std::string name = "wind.grib: ";
    return text.find(name) == std::string::npos ? text : text.substr(text.find(name) + name.size());
}

/// U is 1 at the first point, 1 more per column and 10 more per row; V is -U / 2.
inline double eastward(int column, int row) {
    return 1.0 + column + 10.0 * row;
}
inline double northward(int column, int row) {
    return -0.5 * eastward(column, row);
}

} // namespace osgTreeWind
