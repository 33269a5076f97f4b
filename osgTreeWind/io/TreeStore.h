// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The trees of a document as they are read: in memory, or in a file where they may be more than it should
/// hold. That file has no name and goes with the store. Not thread-safe.
class TreeStore {
public:
    using Trees = std::vector<TreePlacement>;

    /// @param memory where trees are while they are in memory; it outlives the store.
    explicit TreeStore(Trees& memory) : _memory(memory) {}

    /// Has at most that many in memory from now on, others in a file of that folder. @return false where no
    /// file can be made there.
    bool useFile(const std::string& folder, std::size_t most);
    /// @param onGround its height is not known, and it stands on the ground if there is one.
    void add(const TreePlacement& tree, bool onGround);
    bool areInMemory() const { return !_file; } ///< All of them.
    std::size_t size() const { return _stored + _memory.size(); }

    /// Hands over all trees in their order: all at once where they are in memory, else some at a time.
    void visit(const std::function<void(const Trees& trees)>& take);
    /// The same, and they stay as they are left, but for their names.
    /// @param change gets the indices of those that stand on the ground.
    void change(const std::function<void(Trees& trees, const std::vector<std::size_t>& onGround)>& change);
    /// Whether some are lost: the file could not be written or read.
    bool failed() const { return _failed; }

private:
    struct Part {
        long begin = 0;
        std::size_t trees = 0, bytes = 0;
    };
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    /// Null for the part: they are in memory.
    void eachPart(const std::function<void(const Part* part, Trees& trees,
                                           const std::vector<std::size_t>& onGround)>& use);
    void store();
    void write(const Part& part, const std::string& bytes);
    bool load(const Part& part, Trees& trees, std::vector<std::size_t>& onGround);

    Trees& _memory;
    std::vector<std::size_t> _onGround; ///< Of those in memory.
    std::unique_ptr<std::FILE, Close> _file;
    std::vector<Part> _parts;
    std::size_t _most = 0, _stored = 0;
    bool _failed = false;
};

} // namespace osgTreeWind
