// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Field.h>
#include <osgTreeWind/io/TableReader.h>

namespace osgTreeWind {

/// Replaces the name of a file by where it is.
using FileFinder = std::function<void(TableReader& table, const std::string& key, std::string& name)>;

/// Reads those keys of a table that are there into the members they stand for.
/// @param find for texts in "file".
void readFields(TableReader& table, const Fields& fields, void* owner, const FileFinder& find = {});
template <typename Struct>
void readFields(TableReader& table, Struct& value, const FileFinder& find = {}) {
    readFields(table, fieldsOf<Struct>(), &value, find);
}

/// Reports each at its key, or at the other one where the file says only that.
void reportConflicts(TableReader& table, const std::vector<FieldConflict>& conflicts);

} // namespace osgTreeWind
