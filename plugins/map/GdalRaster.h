// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/map/GdalErrors.h>

#include <osgTreeWind/places/MapMessages.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Heights of a raster while they are read: what Raster asks for.
class GdalRaster {
public:
    /// @param band name or number of the band of heights; empty: the only one, or the one that its name
    /// tells.
    GdalRaster(const std::string& path, std::string band);

    Result<RasterHead> head();
    /// After a good head(): metres, some rows after others, NaN for a hole. Ends with a problem, or when
    /// `take` is false or has all rows.
    void read(const std::function<bool(Result<std::vector<float>>)>& take);

private:
    Diagnostic problem(const std::string& message) const;
    void* chosenOf(const std::vector<void*>& bands) const;
    std::string problemOfBands();
    Result<std::vector<float>> rows(int first, int count);
    std::string inMetres(std::vector<float>& heights, int firstRow) const;

    const std::string _path, _wanted; ///< The file; the band.
    std::string _refusal;             ///< Why it is not opened at all.
    const GdalErrors _errors;         ///< From now on.
    std::unique_ptr<void, void (*)(void*)> _data;
    void* _band = nullptr; ///< GDALRasterBandH of the heights.
    int _columns = 0, _rows = 0;
    double _scale = 1.0, _offset = 0.0;
};

/// Reads rows of a band; NaN where its mask says that there is nothing. False where they cannot be read.
/// @param values so many rows and columns of them.
bool readRows(void* band, int first, int count, int columns, float* values);

} // namespace osgTreeWind
