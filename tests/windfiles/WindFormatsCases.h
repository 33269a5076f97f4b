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
    const auto esri = [](std::string_view bytes, const std::string& file) -> Result<WindContent> {
        const Result<RasterBand> grid = readEsriGrid(bytes, file);
        if (!grid)
            return grid.problems();
        return windFromBands(grid.value(), grid.value(), file);
    };
    static const std::vector<FormatCase> cases = {{"vectors.vtk", readVtkLegacy},
                                                  {"field.vtk", readVtkLegacy},
                                                  {"binary.vtk", readVtkLegacy},
                                                  {"paraview.vtk", readVtkLegacy},
                                                  {"paraviewbinary.vtk", readVtkLegacy},
                                                  {"cells.vtk", readVtkLegacy},
                                                  {"rectilinear.vtk", readVtkLegacy},
                                                  {"structured.vtk", readVtkLegacy},
                                                  {"ascii.vti", readVtkXml},
                                                  {"base64.vti", readVtkXml},
                                                  {"zlib.vti", readVtkXml},
                                                  {"raw.vti", readVtkXml},
                                                  {"rawzlib.vti", readVtkXml},
                                                  {"bigendian.vti", readVtkXml},
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
