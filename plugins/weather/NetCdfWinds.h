// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/NetCdfFile.h>

#include <osgTreeWind/wind/WindDirection.h>

#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Two components of wind, or speed and direction, on as many levels as their arrays have.
struct NetCdfWindPair {
    NetCdfFile::Array first, second;
    std::optional<double> height; ///< Metres above ground, where the file says so of all of it.
};

/// Which arrays of a file are wind, and what they mean.
struct NetCdfWinds {
    std::vector<NetCdfWindPair> pairs; ///< Upward; one where its arrays have levels.
    NetCdfFile::Array up;              ///< Null where there is none.
    bool polar = false, fromTrueNorth = false;
    DirectionSense sense = DirectionSense::From;
    std::string direction, unit; ///< As WindSummary has them.
    std::vector<std::string> notes;
};

/// By standard names of the CF conventions, else by usual names. Fails where there is none.
NetCdfWinds windsOf(NetCdfFile& file);

} // namespace osgTreeWind
