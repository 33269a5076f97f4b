// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/NetCdfFile.h>

#include <osgTreeWind/wind/WindDirection.h>

#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Arrays of two components of wind, or of speed and direction.
struct NetCdfWindPair {
    NetCdfFile::Array first, second;
    std::optional<double> height; ///< Metres above ground, if both arrays are at a single height.
};

/// The wind arrays of a file and their meaning.
struct NetCdfWinds {
    std::vector<NetCdfWindPair> pairs; ///< In upward order; only one if its arrays have levels.
    NetCdfFile::Array up;              ///< Vertical velocity; null if there is none.
    bool isPolar = false, fromTrueNorth = false;
    DirectionSense sense = DirectionSense::From;
    std::string direction, unit; ///< As in WindSummary.
    std::vector<std::string> notes;

    /// All wind arrays, none null.
    std::vector<NetCdfFile::Array> arrays() const;
};

/// Finds wind arrays by CF standard names, otherwise by common names. Fails if there are none, or several on
/// the same points. @param variable as WindFileOptions::variable.
NetCdfWinds windsOf(NetCdfFile& file, const std::vector<std::string>& variable);

} // namespace osgTreeWind
