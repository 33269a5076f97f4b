// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace osgTreeWind {

/// What the points of a field lie on, as its sections define it.
struct GribGrid {
    std::string kind;            ///< For people: "Lambert conformal".
    bool even = false;           ///< Points are even on a map, or on longitudes and latitudes.
    bool relativeToGrid = false; ///< Components of vectors are along the grid, not toward east and north.
    std::uint64_t columns = 0, rows = 0;
    std::string definition; ///< Bytes that are the same for the same grid, whatever its components are.
};

/// What a level counts.
enum class GribLevelKind { AboveGround, AboveSea, Isobaric, Model, Surface, Other };

/// A level: metres, Pa, or a number of its own.
struct GribLevel {
    GribLevelKind kind = GribLevelKind::Other;
    int type = 0; ///< As its edition numbers it.
    double value = 0.0;
};

/// Which quantity a field is, as its edition numbers them.
struct GribParameter {
    int edition = 2;
    int centre = 0;   ///< Edition 1.
    int table = 0;    ///< Edition 1: the version of its table. Edition 2: its discipline.
    int category = 0; ///< Edition 2.
    int number = 0;
};

/// One field of a file: what its sections say of it, but for its numbers.
struct GribField {
    std::vector<std::string_view> parts; ///< As GribHandle has them.
    GribParameter parameter;
    GribLevel level;
    bool momentary = false; ///< It holds at one time: no mean, no maximum and no probability.
    double reference = 0.0; ///< Seconds since 1970, when its forecast began.
    double valid = 0.0;     ///< Seconds since 1970, when it holds.
    GribGrid grid;
    std::string problem; ///< Why it cannot be decoded, its times, level and grid neither; empty: it can.
};

/// The fields of a file of GRIB, both editions, in its order, that GribMeaning knows; what is between
/// messages is skipped. A message that is cut, or whose sections contradict its length, is a problem that
/// names it and its byte. One that ecCodes cannot decode is a problem for those only who need it.
/// @param bytes of the file, to which the fields refer.
Result<std::vector<GribField>> readGribFields(std::string_view bytes, const std::string& file);

} // namespace osgTreeWind
