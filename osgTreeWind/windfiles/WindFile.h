// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/Wind.h>
#include <osgTreeWind/windfiles/WindExtent.h>
#include <osgTreeWind/windfiles/WindSeriesColumns.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Options for reading files of wind data.
struct WindFileOptions {
    /// The place, metres in `crs` or else in the file's coordinates, that becomes scene (0, 0, 0). Scene
    /// coordinates are 32-bit floats, so choose an origin near the forest.
    glm::dvec3 origin{0.0};
    /// CRS of `origin` and the scene, projected, in metres, in any notation that PROJ accepts. Places and
    /// velocities of files in another CRS, or in degrees, are transformed to it. Empty: the CRS of the file.
    std::string crs;
    /// With `crs`: minimum x and y, metres from `origin`, of the area needed; other data may be skipped.
    glm::dvec2 low{-50000.0};
    glm::dvec2 high{50000.0}; ///< Maximum x and y of that area.
    /// Unit of speeds, as by sizeOfUnit(): "m/s", "km/h", "kn", "mph", "ft/s" or another. Empty: the unit
    /// that the file states, or else m/s.
    std::string speedUnit;
    /// Roughness length of the ground, metres: the wind follows the logarithmic profile from the ground to
    /// the lowest height of the data, and also above it if there is only one height. 0: the wind is constant
    /// there.
    double roughness = 0.0;
    /// With `roughness`: height above the ground, metres, of a single layer or a record without a height.
    double height = 0.0;
    /// Columns of a CSV or TOA5 table. If none are named: time and u, v, w or speed, direction in CSV, and
    /// TIMESTAMP, Ux, Uy, Uz in TOA5. The unit is `speedUnit` above.
    WindSeriesColumns columns;
    /// Names the wind of a VTK, NetCDF or GRIB file that has several: an array of vectors, or the first
    /// component, or the arrays of each component or of speed and direction. In GRIB, the short names of
    /// ecCodes. Empty: the usual names.
    std::vector<std::string> variable;
    /// Keeps velocities as in the file: does not turn them from true north to the grid's north, and ignores
    /// the motion of a moving model grid.
    bool asStored = false;
};

/// Description of a file of wind data, in the file's coordinates.
struct WindSummary {
    std::string format;      ///< For example "TurbSim full field".
    std::string unit;        ///< Unit of speed in the file; empty if unknown.
    std::string direction;   ///< Meaning of directions or components: "from, degrees clockwise from north".
    std::string coordinates; ///< Name or PROJ text of the CRS; empty if unknown.
    /// The CRS for PROJ, with x east and y north in metres or longitude and latitude in degrees, or empty.
    std::string crs;
    /// Date and time of time 0: ISO 8601 in UTC, unless the file uses another calendar; empty if unknown.
    std::string start;
    std::vector<std::string> notes; ///< Assumptions and other remarks, one sentence each.

    glm::ivec3 points{1}; ///< Number of points east, north and up; (1, 1, 1) for a record at one point.
    glm::dvec3 low{0.0};  ///< South-western lowest point; 0 for a record at one point.
    glm::dvec3 high{0.0}; ///< North-eastern highest point.
    WindExtent extent;    ///< Extent of the whole file, of which only a part may have been read.
    /// Whether a flow model may have computed the wind among trees, as that of VTK and of NetCDF on a fine
    /// grid; false for records and the winds of weather models, which know no single trees.
    bool mayIncludeTrees = false;
    bool aboveGround = false;  ///< Whether heights are above the ground below each place.
    std::vector<double> times; ///< Seconds; empty for a steady wind.
    double slowest = 0.0;      ///< Minimum speed over all points and times, m/s.
    double fastest = 0.0;      ///< Maximum speed over all points and times, m/s.
};

/// A wind read from a file, with a description of the file.
struct WindFile {
    WindSummary summary; ///< The description.
    Wind wind; ///< The wind in the scene, with the transform and clock of the data; its field is not null.
    /// Whether the data cover a place of the scene; elsewhere the wind is clamped to their edge. Always true
    /// for a record at one point.
    std::function<bool(const glm::dvec2& place)> covers;
};

/// Reads a file of wind data, recognised by content, then by extension: ESRI ASCII or GeoTIFF pairs of speed
/// and direction-from (NAME_vel and NAME_ang; give either), legacy VTK grids of even spacing, VTK XML
/// ImageData, TurbSim .bts, Campbell TOA5, EPW, QES-Winds sensor XML, CSV, NetCDF and GRIB.
///
/// With `crs`, files in another CRS are transformed. Without it, a file in degrees is an error, unless
/// `asStored` is set; its places are then in degrees.
///
/// The wind is interpolated between time steps and 0 where data are missing. Velocities relative to true
/// north are turned to the y axis of the file's projection, unless `asStored` is set. Notes report both. A
/// damaged file gives an error with line or byte, never a partial field. Sizes are checked against the file
/// before memory is allocated.
OSGTREEWIND_EXPORT Result<WindFile> readWindFile(const std::string& path,
                                                 const WindFileOptions& options = {});

/// Reads several files on the same grid as one wind, such as the hours of WindNinja or a forecast, or the
/// days of a reanalysis. Velocities are linear between the times and clamped to the first and last.
///
/// A file whose grid, unit or CRS differs from the first is an error; so is a record at one point, or with
/// `times` a file of several times. Notes of later files begin with their file name. Invalid `files` or
/// `times` are errors with that key.
/// @param files at least one, in order of time.
/// @param times seconds, increasing, one for each file; empty if the files contain their times: dates,
/// counted from the first, or VTK's TimeValue. One steady file or pair needs none.
OSGTREEWIND_EXPORT Result<WindFile> readWindFiles(const std::vector<std::string>& files,
                                                  const std::vector<double>& times,
                                                  const WindFileOptions& options = {});

/// Reads a record at one point, m/s, from a file of any format. A grid is an error.
/// @param columns of a table, with their unit. @param notes if not null, set to assumptions and omissions.
OSGTREEWIND_EXPORT Result<WindSeries> readWindSeries(const std::string& path,
                                                     const WindSeriesColumns& columns,
                                                     std::vector<std::string>* notes = nullptr);

} // namespace osgTreeWind
