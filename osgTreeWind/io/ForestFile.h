// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

#include <istream>
#include <string>
#include <vector>

namespace osgTreeWind {

/// A forest that was read from a .treewind document, and how it was read.
struct ForestFile : ForestDescription {
    std::vector<std::string> notes; ///< How the input was interpreted, for the user to review.
    bool crsFromInventory = false;  ///< `crs` was chosen for an inventory and is not in the document.
    std::string source;             ///< Text of the document; empty if settings have overridden its keys.
};

/// Options for reading a .treewind document.
struct ForestFileOptions {
    std::string file;   ///< Name used in diagnostics; may be empty.
    std::string folder; ///< Folder of the document, for relative paths in it; empty: the current folder.
    std::size_t maxTrees = 1000000; ///< More trees are an error.
    /// Keys that override the document: "wind.speed=15", "season=autumn". A value that is not TOML is a text.
    /// Keys in arrays of tables cannot be overridden.
    std::vector<std::string> settings = {};
};

/// Reads a .treewind document (docs/treewind.md) and the files it names. Thread-safe.
///
/// Relative paths are searched in `options.folder`, then in each folder of the document's `search`, then in
/// the folder given by the environment variable OSGTREEWIND_DATA. Reading `source` again with its `folder`
/// gives the same forest.
/// @return the forest, or all problems found (at most 100), those of the document first, sorted by position.
OSGTREEWIND_EXPORT Result<ForestFile> readForest(std::istream& input, const ForestFileOptions& options = {});

/// Reads a .treewind file; relative paths refer to its folder.
/// @param path of a regular file. @param maxTrees, settings as in ForestFileOptions.
OSGTREEWIND_EXPORT Result<ForestFile> readForestFile(const std::string& path, std::size_t maxTrees = 1000000,
                                                     const std::vector<std::string>& settings = {});

/// Writes a document that reads back as exactly the same forest, except that paths become absolute, and sizes
/// of 0 or less read back as 0 (not given). Thread-safe.
/// @return the problems, in which case nothing is written: those of check(), duplicate names of species or
/// trees, a wind that is a callable, streamed or moved, and scans or pictures without a file.
[[nodiscard]] OSGTREEWIND_EXPORT Diagnostics writeForest(const ForestDescription& description,
                                                         std::ostream& output);

/// Writes a forest to a file, as writeForest() does.
[[nodiscard]] OSGTREEWIND_EXPORT Diagnostics writeForestFile(const ForestDescription& description,
                                                             const std::string& path);

/// Writes a forest as an edit of the file that it was read from. If only season, wind, motion and drawing
/// have changed, it changes those keys in the text of `from` and keeps comments and order; otherwise it is
/// the same as writeForestFile(). @param path may equal `from`.
[[nodiscard]] OSGTREEWIND_EXPORT Diagnostics editForestFile(const ForestDescription& forest,
                                                            const std::string& from, const std::string& path);

} // namespace osgTreeWind
