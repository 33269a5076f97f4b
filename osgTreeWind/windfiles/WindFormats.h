// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/places/MapCells.h>
#include <osgTreeWind/windfiles/WindContent.h>
#include <osgTreeWind/windfiles/WindRequest.h>

#include <limits>
#include <string>
#include <string_view>

/// The readers behind readWindFile(), one for each format, most over bytes in memory. Not part of the
/// interface. Each gives a record, or a grid with as many values as its points say, or a problem with a line
/// or a byte.
namespace osgTreeWind {

/// The one door: the file in whichever of the formats below it is, by its first kilobyte, then by extension.
/// What of a format can be left unread beyond the area, may be.
Result<WindContent> readWindContent(const std::string& path, const WindRequest& request);

/// The value of a cell without data.
constexpr float noData = std::numeric_limits<float>::quiet_NaN();

/// An ESRI ASCII grid: numbers from the north-western cell on, east fastest.
Result<MapCells> readEsriGrid(std::string_view text, const std::string& file);
/// Speed and direction-from on the same cells as one wind.
Result<WindContent> windOfCells(const MapCells& speed, const MapCells& direction, const std::string& file);
/// Both files of a pair NAME_vel and NAME_ang, either given; the map is that of a .prj beside each.
Result<WindContent> readEsriPair(const std::string& path);
/// The same pair as GeoTIFF, read by the program osgtreewind-map.
Result<WindContent> readTiffPair(const std::string& path);

/// Legacy VTK, ASCII or BINARY, versions 2 to 5.1: STRUCTURED_POINTS, or RECTILINEAR_GRID or STRUCTURED_GRID
/// of evenly spaced points. Its TimeValue becomes the one time of the grid.
Result<WindContent> readVtkLegacy(std::string_view bytes, const std::string& file);
/// VTK XML ImageData of one piece: ascii, base64 or raw, zlib or not, either byte order.
Result<WindContent> readVtkXml(std::string_view bytes, const std::string& file);
/// TurbSim full field: the grid drifts along x with the mean wind at the hub (Taylor's frozen turbulence).
Result<WindContent> readTurbSim(std::string_view bytes, const std::string& file);
/// Campbell TOA5: four lines of header, the third with units. Records without a wind are left out.
Result<WindContent> readToa5(std::string_view bytes, const std::string& file,
                             const WindSeriesColumns& columns);
/// QES-Winds sensor: XML, with or without a single root, whose `timeSeries` elements each hold timeEpoch (s)
/// or timeStamp (a date and time), height and siteZ0 (m), speed (m/s) and direction (degrees from). Times
/// become seconds since the first; height and roughness become the profile.
///
/// Problems carry line and column: broken XML, a missing or repeated element, text in a number, values no
/// wind has, times that do not increase. Only the neutral logarithmic profile is read (boundaryLayerFlag 1
/// and reciprocal 0, both the defaults when absent), with one height and roughness for the whole record.
Result<WindContent> readQesSensor(std::string_view bytes, const std::string& file);
/// EnergyPlus weather: eight lines of header, then a row for each hour of a year that may be put together
/// from months of several years. Its winds are those at 10 m.
Result<WindContent> readEpw(std::string_view bytes, const std::string& file);
/// CSV, and what WindSeriesRows says of it. While it names no column, the usual names.
Result<WindContent> readWindCsv(std::string_view bytes, const std::string& file,
                                const WindSeriesColumns& columns);
/// NetCDF, read by the program osgtreewind-weather in a process of its own: a damaged file ends that one
/// only. An error where it is not installed.
Result<WindContent> readNetCdf(const std::string& path, const WindRequest& request);
/// GRIB, edition 1 or 2, read by the same program.
Result<WindContent> readGrib(const std::string& path, const WindRequest& request);

} // namespace osgTreeWind
