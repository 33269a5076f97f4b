// SPDX-License-Identifier: MIT
#pragma once

#include <tests/Folders.h>

#include <osgTreeWind/windfiles/WindFormats.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace osgTreeWind {

/// A small file and the reader of its format.
struct FormatCase {
    const char* file;
    Result<WindContent> (*read)(std::string_view bytes, const std::string& file);
};

inline const std::vector<FormatCase>& formatCases() {
    const auto toa5 = [](std::string_view bytes, const std::string& file) {
        return readToa5(bytes, file, {});
    };
    const auto legacy = [](std::string_view bytes, const std::string& file) {
        return readVtkLegacy(bytes, file);
    };
    const auto xml = [](std::string_view bytes, const std::string& file) { return readVtkXml(bytes, file); };
    const auto esri = [](std::string_view bytes, const std::string& file) -> Result<WindContent> {
        const Result<RasterBand> grid = readEsriGrid(bytes, file);
        if (!grid)
            return grid.problems();
        return windFromBands(grid.value(), grid.value(), file);
    };
    static const std::vector<FormatCase> cases = {{"vectors.vtk", legacy},
                                                  {"field.vtk", legacy},
                                                  {"binary.vtk", legacy},
                                                  {"paraview.vtk", legacy},
                                                  {"paraviewbinary.vtk", legacy},
                                                  {"cells.vtk", legacy},
                                                  {"rectilinear.vtk", legacy},
                                                  {"structured.vtk", legacy},
                                                  {"ascii.vti", xml},
                                                  {"base64.vti", xml},
                                                  {"zlib.vti", xml},
                                                  {"raw.vti", xml},
                                                  {"rawzlib.vti", xml},
                                                  {"bigendian.vti", xml},
                                                  {"small.bts", readTurbSim},
                                                  {"toa5.dat", toa5},
                                                  {"pair_vel.asc", esri},
                                                  {"pair_ang.asc", esri}};
    return cases;
}

inline std::string bytesOf(const FormatCase& format) {
    std::ifstream file(std::string(OSGTREEWIND_TEST_DATA) + "/wind/" + format.file, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace osgTreeWind
