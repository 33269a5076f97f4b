// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace osgTreeWind {

/// How a forest is read as a stream.
struct ForestStreamOptions {
    std::string folder;                ///< Of the file that trees lie in; it is there.
    std::size_t mostTrees = 100000000; ///< More than these are a problem.
    std::size_t treesAtOnce = 262144;  ///< In memory, at least 1; some 100 bytes each.
};

/// The forest of a file that may have more trees than memory should hold: they lie in a file without a name,
/// 72 bytes each and their ids. In memory are ids, places of a [[scatter]] with a spacing, and the text
/// of a table. Not thread-safe.
///
///     const auto city = ForestStream::read("city.treewind", {"/tmp"});
///     if (city)
///         report(writeTiledForest(city.value(), "world").problems());
class OSGTREEWIND_EXPORT ForestStream {
public:
    /// Reads what readForestFile() reads. @return it, or every problem found; one with the folder as its file
    /// where that cannot hold the trees.
    static Result<ForestStream> read(const std::string& path, const ForestStreamOptions& options);

    ForestStream();
    ForestStream(ForestStream&&) noexcept;            ///< What was read goes along.
    ForestStream& operator=(ForestStream&&) noexcept; ///< What was read goes along.
    ~ForestStream();

    /// Without its trees.
    const ForestDescription& description() const;
    std::size_t treeCount() const; ///< Of all that were read.
    /// Hands over all trees in their order, some at a time. @return false where the file cannot be read.
    bool visit(const std::function<void(const std::vector<TreePlacement>& trees)>& take) const;

private:
    struct Reading;
    std::unique_ptr<Reading> _reading;
};

} // namespace osgTreeWind
