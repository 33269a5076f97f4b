// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace osgTreeWind {

/// The grid of a field, as its sections define it.
struct GribGrid {
    std::string kind;    ///< Name for messages: "Lambert conformal".
    bool isEven = false; ///< Points are evenly spaced in longitude and latitude or in a map projection.
    bool relativeToGrid = false; ///< Vector components are along the grid axes, not toward east and north.
    std::uint64_t columns = 0, rows = 0;
    std::string definition; ///< To compare grids, without `relativeToGrid`.
};

/// What the value of a level means.
enum class GribLevelKind { AboveGround, AboveSea, Isobaric, Model, Surface, Other };

/// A vertical level.
struct GribLevel {
    GribLevelKind kind = GribLevelKind::Other;
    long type = 0;      ///< Number in the tables of its edition.
    double value = 0.0; ///< Metres, Pa or a number.
};

/// The quantity of a field, as numbers of its edition.
struct GribParameter {
    int edition = 2;
    long centre = 0;   ///< Edition 1 only.
    long table = 0;    ///< Edition 1: version of the table; edition 2: discipline.
    long category = 0; ///< Edition 2 only.
    long number = 0;
};

/// The description of a field of a file, without its values.
struct GribField {
    std::vector<std::string_view> parts; ///< The message, as for GribHandle.
    GribParameter parameter;
    std::string name, variable; ///< Short name of ecCodes, "10u", and its name in NetCDF, "u10".
    GribLevel level;
    bool isInstantaneous = false; ///< At a single time: not a mean, maximum or probability.
    double reference = 0.0;       ///< Start of the forecast, seconds since 1970.
    double valid = 0.0;           ///< Time of the field, seconds since 1970.
    GribGrid grid;
    std::string problem; ///< Why it cannot be decoded, with times, level and grid unset; empty if it can.
};

/// Reads the fields of a GRIB file, edition 1 or 2, whose quantities GribMeaning knows, in the order of the
/// file. Bytes between messages are skipped. A truncated message, or one whose sections contradict its
/// length, is a problem with message number and byte; a message that ecCodes cannot decode only sets
/// GribField::problem.
/// @param bytes of the file; must outlive the fields.
Result<std::vector<GribField>> readGribFields(std::string_view bytes, const std::string& file);

} // namespace osgTreeWind
