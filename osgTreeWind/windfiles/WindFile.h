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

/// How a file of wind data is to be taken.
struct WindFileOptions {
    /// The place in the file's coordinates, metres, that becomes (0, 0, 0) of the scene. Scenes count in
    /// 32-bit floats, so give map coordinates an origin near the forest.
    glm::dvec3 origin{0.0};
    /// The map on which `origin` and the scene are, in metres, by any text that PROJ knows: a file that says
    /// to be on another, or on degrees, is brought to it, places and velocities. Empty: the file's own.
    std::string crs;
    /// With `crs`, where wind is wanted, least x and y, metres from `origin`: what lies well beyond need not
    /// be read.
    glm::dvec2 low{-50000.0};
    glm::dvec2 high{50000.0}; ///< Greatest x and y of it.
    /// Unit of speeds where the file does not say: "m/s", "km/h", "kn", "mph" or "ft/s".
    std::string speedUnit = "m/s";
    /// Roughness length of the ground, metres, below the lowest height of the data: wind beneath follows the
    /// logarithmic profile to the foot of each tree, and that of a single height also above it. 0: it holds.
    double roughness = 0.0;
    /// With `roughness`, metres above the ground at which data hold that do not say: a single layer, or a
    /// record.
    double height = 0.0;
    /// Of a CSV or TOA5 table; while it names none, the columns are called time, u, v, w or time, speed,
    /// direction in a CSV and TIMESTAMP, Ux, Uy, Uz in a TOA5. The unit is `speedUnit` above.
    WindSeriesColumns columns;
    /// Velocities as the file has them: not turned from true north to the grid's, a model grid that moves
    /// taken as standing still.
    bool asStored = false;
};

/// What a file of wind data was understood to say, in the file's own coordinates.
struct WindSummary {
    std::string format;      ///< "TurbSim full field", say.
    std::string unit;        ///< Of the speeds in the file; empty when it does not say.
    std::string direction;   ///< "from, clockwise from grid north" or what the components mean.
    std::string coordinates; ///< Name or PROJ text of the reference system; empty when not said.
    /// The same as PROJ reads it, where points are x east and y north of a map in metres, or longitude and
    /// latitude in degrees; empty when not said.
    std::string crs;
    /// Date and time of time 0, as ISO 8601 in UTC where the file's calendar is the usual one; empty when it
    /// does not say.
    std::string start;
    std::vector<std::string> notes; ///< What else is worth knowing, one sentence each.

    glm::ivec3 points{1};      ///< Points east, north and up; 1, 1, 1 for a record at one point.
    glm::dvec3 low{0.0};       ///< South-western lowest point; all 0 for a record at one point.
    glm::dvec3 high{0.0};      ///< North-eastern highest point.
    WindExtent extent;         ///< Of all points of the file, of which those near the scene may be a part.
    bool aboveGround = false;  ///< Heights count from the ground below each place.
    std::vector<double> times; ///< Seconds; empty for a wind that does not change.
    double slowest = 0.0;      ///< m/s, over all points and times.
    double fastest = 0.0;      ///< m/s, likewise.
};

/// A file of wind data as a wind, and what was understood.
struct WindFile {
    WindSummary summary; ///< What it says of itself.
    Wind wind;           ///< In the scene: a field, never null, with the map and the clock of the data.
    /// Whether the file has points around a place of the scene, so that its wind there is not that of its
    /// edge; of a record at one point it has all.
    std::function<bool(const glm::dvec2& place)> covers;
};

/// Reads wind data, recognised by content, then by extension: ESRI ASCII pairs of speed and direction-from
/// (NAME_vel.asc and NAME_ang.asc, either given), legacy VTK grids of even spacing, VTK XML ImageData,
/// TurbSim .bts, Campbell TOA5, QES-Winds sensor XML, CSV, NetCDF and GRIB.
///
/// With a `crs` a file on another map is re-projected. Without, one on degrees is an error, unless it is
/// wanted as stored: its places are degrees then.
///
/// Time steps are interpolated. Places without data are calm, and velocities that count from true north are
/// turned to the y axis of a NetCDF file's projection, unless wanted as stored; notes say both. A broken file
/// gives an error with line or byte, never a partial field. Sizes are checked against the file before memory
/// is asked for.
OSGTREEWIND_EXPORT Result<WindFile> readWindFile(const std::string& path,
                                                 const WindFileOptions& options = {});

/// Reads several files on the same grid as one wind: the hours of WindNinja or of a forecast, the days of a
/// reanalysis. Velocities are linear between the times; the first holds before, the last after.
///
/// A file of another grid, unit or reference system than the first is an error that names it; so is a record
/// at one point, or with `times` a file of several. Notes that the first file does not have too begin with
/// the name of theirs. Wrong `files` or `times` are errors with that key.
/// @param files at least one, in the order of their times. @param times seconds, increasing, one for each
/// file; none where each file says its own: dates, which count from the first, or VTK's TimeValue.
OSGTREEWIND_EXPORT Result<WindFile> readWindFiles(const std::vector<std::string>& files,
                                                  const std::vector<double>& times,
                                                  const WindFileOptions& options = {});

/// A record at one point as it is, m/s: of any format that holds one; of a table with these columns, their
/// unit among them. A grid is an error.
/// @param notes where not null, what had to be assumed and what was left out.
OSGTREEWIND_EXPORT Result<WindSeries> readWindSeries(const std::string& path,
                                                     const WindSeriesColumns& columns,
                                                     std::vector<std::string>* notes = nullptr);

} // namespace osgTreeWind
