// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/system/File.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Spools the trees of a document in memory, or in an unnamed temporary file. Not thread-safe.
class TreeSpool {
public:
    using Trees = std::vector<TreePlacement>;

    /// @param memory holds trees that are in memory; must outlive the spool.
    explicit TreeSpool(Trees& memory) : _memory(memory) {}

    /// From now on, keeps at most that many trees in memory, and the others in a file. @return false if the
    /// file cannot be created in the folder.
    bool useFile(const std::string& folder, std::size_t maxInMemory);
    /// @param onGround the height is unknown, and the tree stands on the ground if there is one.
    void add(const TreePlacement& tree, bool onGround);
    /// Moves the trees in memory to the file, if there is one.
    void flush();
    bool isInMemory() const { return !_file; } ///< Whether useFile() was not called.
    std::size_t size() const { return _stored + _memory.size(); }

    /// Visits all trees in order: in one batch if they are in memory, otherwise in several.
    void
    visit(const std::function<void(const Trees& trees, const std::vector<std::size_t>& onGround)>& visitor);
    /// Visits all trees and stores their changes. Must not change names.
    /// @param modifier gets the indices of trees on the ground.
    void modify(const std::function<void(Trees& trees, const std::vector<std::size_t>& onGround)>& modifier);
    /// Whether trees were lost because the file could not be written or read.
    bool hasFailed() const { return _failed; }

private:
    struct Part {
        std::int64_t begin = 0;
        std::size_t trees = 0, bytes = 0;
    };
    /// @param visitor gets a null part for trees in memory.
    void forEachPart(const std::function<void(const Part* part, Trees& trees,
                                              const std::vector<std::size_t>& onGround)>& visitor);
    void write(const Part& part, const std::string& bytes);
    bool load(const Part& part, Trees& trees, std::vector<std::size_t>& onGround);

    Trees& _memory;
    std::vector<std::size_t> _onGround; ///< Indices into `_memory`.
    FilePointer _file;
    std::vector<Part> _parts;
    std::size_t _maxInMemory = 0, _stored = 0;
    bool _failed = false;
};

} // namespace osgTreeWind
