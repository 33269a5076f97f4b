// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

#include <istream>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Where a document came from.
struct ForestFileOptions {
    std::string file;   ///< Name used in diagnostics; may be empty.
    std::string folder; ///< Folder of the document, for relative paths in it; empty: the current folder.
    std::size_t mostTrees = 1000000; ///< More than these are a problem.
    /// Keys to be other than the document says: "wind.speed=15", "season=autumn". What is not TOML's is a
    /// text; not in arrays of tables.
    std::vector<std::string> settings = {};
};

/// Reads a .treewind document (docs/treewind.md) and the files it names.
///
/// Relative paths are looked for in `options.folder`, then in each folder of the document's `search`, then in
/// the folder that the environment variable OSGTREEWIND_DATA names. `source` and `folder` of the description
/// are such that reading `source` with that folder gives the same forest again.
/// @return the forest, or every problem found (at most 100), those of the document first, in order of place.
/// Thread-safe: keeps no state.
OSGTREEWIND_EXPORT Result<ForestDescription> readForest(std::istream& input,
                                                        const ForestFileOptions& options = {});

/// Opens `path` and reads it with its own folder as the folder for relative paths.
/// @param path of a regular file. @param mostTrees, settings as ForestFileOptions has them.
OSGTREEWIND_EXPORT Result<ForestDescription> readForestFile(const std::string& path,
                                                            std::size_t mostTrees = 1000000,
                                                            const std::vector<std::string>& settings = {});

/// Writes what reads back as the same forest, field by field and bit by bit; not its `notes`, and paths
/// become absolute ones. A size that is not above 0 reads back as 0: not given.
/// @return what keeps it from being written, before anything is: check(), species or trees of one name, a
/// wind that is a callable, streamed or moved, scans and pictures without a file. Empty when all is well.
/// Thread-safe.
OSGTREEWIND_EXPORT Diagnostics writeForest(const ForestDescription& description, std::ostream& output);

/// The same into a file.
OSGTREEWIND_EXPORT Diagnostics writeForestFile(const ForestDescription& description, const std::string& path);

/// The same as an edit of the file that the forest was read from: where nothing but its season, wind, motion
/// and drawing are others now, the file's text with those keys changed, its comments and order kept. Whatever
/// cannot be said so is written as by writeForestFile(). @param path may be `from`.
OSGTREEWIND_EXPORT Diagnostics editForestFile(const ForestDescription& now, const std::string& from,
                                              const std::string& path);

} // namespace osgTreeWind
