// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Key.h>
#include <osgTreeWind/io/TableReader.h>

namespace osgTreeWind {

/// Replaces the name of a file by its path.
using FileFinder = std::function<void(TableReader& table, const std::string& key, std::string& name)>;

/// Reads the keys present in a table into the members of a struct.
/// @param find for keys with the unit "file".
void readKeys(TableReader& table, const Keys& keys, void* owner, const FileFinder& find = {});
template <typename Struct>
void readKeys(TableReader& table, Struct& value, const FileFinder& find = {}) {
    readKeys(table, keysOf<Struct>(), &value, find);
}

/// Reports each conflict at its key, or at the other key if the table has only that one.
void reportConflicts(TableReader& table, const std::vector<KeyConflict>& conflicts);

} // namespace osgTreeWind
