// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/ForestSections.h>

#include <optional>
#include <string>

namespace osgTreeWind {

/// Reads files of wind data, in world coordinates moved by `offset`. Null after a problem.
/// @param date gets that of the time 0, seconds since 1970, if the files state it.
Wind readWindData(TableReader& table, const InputFolders& folders, const ForestDescription& forest,
                  DocumentTrees& trees, std::optional<double>& date);

/// Reads the name of a speed unit; default "m/s". @return the unit in m/s; empty if it is unknown.
std::optional<double> readSpeedUnit(TableReader& table, const std::string& key, std::string& name);

/// Reports problems of a wind made from this table: at the key that they name, or else at the table.
void reportWindProblems(const Diagnostics& problems, TableReader& table);

} // namespace osgTreeWind
