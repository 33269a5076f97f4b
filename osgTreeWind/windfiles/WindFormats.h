// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/places/RasterBand.h>
#include <osgTreeWind/windfiles/WindContent.h>
#include <osgTreeWind/windfiles/WindRequest.h>

#include <limits>
#include <string>
#include <string_view>

/// Readers of each wind format for readWindFile(). Each returns a record, a grid with values for all of its
/// points, or a problem with line or byte.
namespace osgTreeWind {

/// Reads a file in any of the formats below, recognised by its first kilobyte, then by its extension. Readers
/// may skip data outside the area of the request.
Result<WindContent> readWindContent(const std::string& path, const WindRequest& request);

/// Value of a cell without data.
constexpr float noData = std::numeric_limits<float>::quiet_NaN();

/// Reads an ESRI ASCII grid, stored row by row from the north-western cell.
Result<RasterBand> readEsriGrid(std::string_view text, const std::string& file);
/// Combines speed and direction-from on the same cells.
Result<WindContent> windFromBands(const RasterBand& speed, const RasterBand& direction,
                                  const std::string& file);
/// Reads the ESRI ASCII pair NAME_vel and NAME_ang; `path` is either. A .prj beside each gives the CRS.
Result<WindContent> readEsriPair(const std::string& path);
/// Reads the same pair as GeoTIFF with the program osgtreewind-map.
Result<WindContent> readTiffPair(const std::string& path);

/// Reads legacy VTK, ASCII or BINARY, versions 2 to 5.1: STRUCTURED_POINTS, or RECTILINEAR_GRID or
/// STRUCTURED_GRID with evenly spaced points. A TimeValue becomes the only time of the grid.
/// @param variable as WindFileOptions::variable.
Result<WindContent> readVtkLegacy(std::string_view bytes, const std::string& file,
                                  const std::vector<std::string>& variable = {});
/// Reads VTK XML ImageData of one piece: ascii, base64 or raw, optionally zlib, either byte order.
/// @param variable as WindFileOptions::variable.
Result<WindContent> readVtkXml(std::string_view bytes, const std::string& file,
                               const std::vector<std::string>& variable = {});
/// Reads a TurbSim full field, which drifts along x with the mean wind at the hub (frozen turbulence).
Result<WindContent> readTurbSim(std::string_view bytes, const std::string& file);
/// Reads Campbell TOA5, with four header lines, the third with units. Skips records without wind.
Result<WindContent> readToa5(std::string_view bytes, const std::string& file,
                             const WindSeriesColumns& columns);
/// Reads a QES-Winds sensor: XML, with or without a single root, whose `timeSeries` elements each contain
/// timeEpoch (s) or timeStamp (date and time), height and siteZ0 (m), speed (m/s) and direction (degrees
/// from). Times become seconds since the first; height and roughness become the profile.
///
/// Problems, with line and column: broken XML, a missing or repeated element, text in a number, impossible
/// values, times that do not increase. Supports only the neutral logarithmic profile (boundaryLayerFlag 1 and
/// reciprocal 0, the defaults) with one height and roughness for the whole record.
Result<WindContent> readQesSensor(std::string_view bytes, const std::string& file);
/// Reads EnergyPlus weather: eight header lines, then a row for each hour of a year, which may be composed of
/// months from several years. The wind is at 10 m.
Result<WindContent> readEpw(std::string_view bytes, const std::string& file);
/// Reads CSV; see WindSeriesRows. Uses the default column names if none are given.
Result<WindContent> readWindCsv(std::string_view bytes, const std::string& file,
                                const WindSeriesColumns& columns);
/// Reads NetCDF with the program osgtreewind-weather, so that a damaged file can only crash that process. An
/// error if it is not installed.
Result<WindContent> readNetCdf(const std::string& path, const WindRequest& request);
/// Reads GRIB, edition 1 or 2, with the same program.
Result<WindContent> readGrib(const std::string& path, const WindRequest& request);

} // namespace osgTreeWind
