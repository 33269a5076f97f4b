// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/map/GdalErrors.h>

#include <osgTreeWind/places/MapMessages.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace osgTreeWind {

/// An open raster of heights, which Raster reads through this program.
class GdalRaster {
public:
    /// @param band name or number; empty: the only band, or the only one with a name for heights.
    GdalRaster(const std::string& path, std::string band);

    Result<RasterHeader> head();
    /// Reads all rows in blocks, in metres, NaN for missing heights. Call it after head() succeeded. Stops at
    /// a problem, or if `take` returns false.
    void read(const std::function<bool(Result<std::vector<float>>)>& take);

private:
    Diagnostic problem(const std::string& message) const;
    void* chooseBand(const std::vector<void*>& bands) const;
    std::string problemOfBands();
    Result<std::vector<float>> rows(int first, int count);
    std::string convertToMetres(std::vector<float>& heights, int firstRow) const;

    const std::string _path, _bandName;
    std::string _formatProblem; ///< Why the file was not opened.
    const GdalErrors _errors;   ///< Of GDAL, from the opening on.
    std::unique_ptr<void, void (*)(void*)> _data;
    void* _band = nullptr; ///< GDALRasterBandH of the heights.
    int _columns = 0, _rows = 0;
    double _scale = 1.0, _offset = 0.0;
};

/// Reads rows of a band, with NaN where its mask has no data. @param values array of count x columns.
/// @return false if reading failed.
bool readRows(void* band, int first, int count, int columns, float* values);

} // namespace osgTreeWind
