// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/ForestSections.h>

#include <optional>
#include <string>

namespace osgTreeWind {

/// Reads files of wind data, in world coordinates moved by `offset`. Null after a problem.
Wind readWindData(TableReader& table, ForestReading& reading);

/// Reads the name of a speed unit; default "m/s". @return the unit in m/s; empty if it is unknown.
std::optional<double> readSpeedUnit(TableReader& table, const std::string& key, std::string& name);

/// Reports problems of a wind made from this table: at the key that they name, or else at the table.
void reportWindProblems(const Diagnostics& problems, TableReader& table, ForestReading& reading);

} // namespace osgTreeWind
