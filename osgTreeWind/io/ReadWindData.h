// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/ForestSections.h>

#include <optional>
#include <string>

namespace osgTreeWind {

/// Any file of wind data, or several; positions in it are world coordinates, moved by
/// `offset`. Null after a problem.
Wind readWindData(TableReader& table, ForestReading& reading);

/// Name of a unit of speed, "m/s" when the key is not there. @return the unit in m/s, if it is one.
std::optional<double> readSpeedUnit(TableReader& table, const std::string& key, std::string& name);

/// Passes on what is wrong with a field made from this table: at the key it names, else at the table.
void reportWind(const Diagnostics& problems, TableReader& table, ForestReading& reading);

} // namespace osgTreeWind
