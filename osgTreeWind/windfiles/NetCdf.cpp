// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/NetCdfFile.h>
#include <osgTreeWind/windfiles/WindFormats.h>

#include <cpl_error.h>

#include <exception>

namespace osgTreeWind {

namespace {

/// Keeps GDAL's messages off the screen of the program.
class Quiet {
public:
    Quiet() { CPLPushErrorHandler(CPLQuietErrorHandler); }
    ~Quiet() { CPLPopErrorHandler(); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;
};

} // namespace

Result<WindContent> readNetCdf(const std::string& path, bool asStored) {
    try {
        const Quiet quiet;
        NetCdfFile file(path);
        if (!file.good())
            return file.problem();
        const NetCdfFile::Array u = file.array("U");
        const bool staggered =
            u && u->GetDimensionCount() == 4 && u->GetDimensions()[3]->GetName() == "west_east_stag";
        return staggered ? readNetCdfWrf(file, asStored) : readNetCdfCf(file, asStored);
    } catch (const std::exception& error) { // what the libraries below throw stops here
        return Diagnostic{path, 0, 0, {}, std::string("cannot be read: ") + error.what()};
    }
}

} // namespace osgTreeWind
