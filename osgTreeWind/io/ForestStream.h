// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/io/ForestFile.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Options for reading a forest as a stream.
struct ForestStreamOptions {
    std::string folder;               ///< Existing folder for the temporary file with the trees.
    std::size_t maxTrees = 100000000; ///< More trees are an error.
    std::size_t treesAtOnce = 262144; ///< Trees in memory, at least 1; about 100 bytes each.
};

/// Reads a forest whose trees may not fit into memory. It keeps them in an unnamed temporary file, with 72
/// bytes and the id of each. Ids, spaced [[scatter]] places and tables' texts stay in memory. Not
/// thread-safe.
///
///     const auto city = ForestStream::read("city.treewind", {"/tmp"});
///     if (city)
///         report(writeTiledForest(city.value(), "world").problems());
class OSGTREEWIND_EXPORT ForestStream {
public:
    /// Reads a .treewind file, as readForestFile() does. @return the forest, or all problems found. If the
    /// folder cannot hold the trees, the problem's `file` is the folder.
    static Result<ForestStream> read(const std::string& path, const ForestStreamOptions& options);

    ForestStream();                                   ///< Empty.
    ForestStream(ForestStream&&) noexcept;            ///< Moves the forest.
    ForestStream& operator=(ForestStream&&) noexcept; ///< Moves the forest.
    ~ForestStream();

    /// The forest without its trees.
    const ForestFile& file() const;
    std::size_t treeCount() const; ///< Number of trees read.
    /// Visits all trees in order and in batches. @return false if the temporary file cannot be read.
    bool visit(const std::function<void(const std::vector<TreePlacement>& trees)>& visitor) const;

private:
    struct Reading;
    std::unique_ptr<Reading> _reading;
};

} // namespace osgTreeWind
