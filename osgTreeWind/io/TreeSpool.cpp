// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TreeSpool.h>

#include <cstring>
#include <tuple>
#include <type_traits>
#include <utility>

namespace osgTreeWind {

namespace {

/// All members of a tree except its name.
template <typename Tree>
auto storedParts(Tree& tree) {
    return std::tie(tree.position, tree.species, tree.size, tree.heading, tree.leaves, tree.seed,
                    tree.openGrown, tree.atEdge, tree.estimated);
}

void append(std::string& bytes, const TreePlacement& tree, bool onGround) {
    const auto add = [&](const auto&... parts) {
        static_assert((std::is_trivially_copyable_v<std::decay_t<decltype(parts)>> && ...));
        (bytes.append(reinterpret_cast<const char*>(&parts), sizeof parts), ...);
    };
    std::apply(add, storedParts(tree));
    add(onGround, tree.name.size());
    bytes += tree.name;
}

/// @return the begin of the next tree.
const char* deserialize(const char* bytes, TreePlacement& tree, bool& onGround) {
    const auto read = [&](auto&... parts) {
        ((std::memcpy(static_cast<void*>(&parts), bytes, sizeof parts), bytes += sizeof parts), ...);
    };
    std::size_t length = 0;
    std::apply(read, storedParts(tree));
    read(onGround, length);
    tree.name.assign(bytes, length);
    return bytes + length;
}

std::string serialize(const TreeSpool::Trees& trees, const std::vector<std::size_t>& onGround) {
    std::string bytes;
    bytes.reserve(trees.size() * sizeof(TreePlacement));
    auto next = onGround.begin();
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const bool isOnGround = next != onGround.end() && *next == i;
        append(bytes, trees[i], isOnGround);
        if (isOnGround)
            ++next;
    }
    return bytes;
}

} // namespace

bool TreeSpool::useFile(const std::string& folder, std::size_t maxInMemory) {
    _file = openVanishingFile(folder);
    _maxInMemory = maxInMemory;
    return _file != nullptr;
}

void TreeSpool::add(const TreePlacement& tree, bool onGround) {
    if (onGround)
        _onGround.push_back(_memory.size());
    _memory.push_back(tree);
    if (_file && _memory.size() >= _maxInMemory)
        flush();
}

void TreeSpool::flush() {
    if (!_file || _memory.empty())
        return;
    const std::string bytes = serialize(_memory, _onGround);
    Part part;
    if (!_parts.empty())
        part.begin = _parts.back().begin + static_cast<std::int64_t>(_parts.back().bytes);
    part.trees = _memory.size();
    part.bytes = bytes.size();
    write(part, bytes);
    _parts.push_back(part);
    _stored += part.trees;
    _memory.clear();
    _onGround.clear();
}

void TreeSpool::write(const Part& part, const std::string& bytes) {
    if (bytes.size() != part.bytes || !seekFile(_file.get(), part.begin) ||
        std::fwrite(bytes.data(), 1, bytes.size(), _file.get()) != bytes.size() ||
        std::fflush(_file.get()) != 0)
        _failed = true;
}

bool TreeSpool::load(const Part& part, Trees& trees, std::vector<std::size_t>& onGround) {
    std::string bytes(part.bytes, '\0');
    if (_failed || !seekFile(_file.get(), part.begin) ||
        std::fread(bytes.data(), 1, bytes.size(), _file.get()) != bytes.size()) {
        _failed = true;
        return false;
    }
    trees.resize(part.trees);
    onGround.clear();
    const char* next = bytes.data();
    for (std::size_t i = 0; i < trees.size(); ++i) {
        bool isOnGround = false;
        next = deserialize(next, trees[i], isOnGround);
        if (isOnGround)
            onGround.push_back(i);
    }
    return true;
}

void TreeSpool::visit(
    const std::function<void(const Trees& trees, const std::vector<std::size_t>& onGround)>& visitor) {
    forEachPart([&](const Part*, Trees& trees, const std::vector<std::size_t>& onGround) {
        visitor(trees, onGround);
    });
}

void TreeSpool::modify(
    const std::function<void(Trees& trees, const std::vector<std::size_t>& onGround)>& modifier) {
    forEachPart([&](const Part* part, Trees& trees, const std::vector<std::size_t>& onGround) {
        modifier(trees, onGround);
        if (part)
            write(*part, serialize(trees, onGround));
    });
}

void TreeSpool::forEachPart(
    const std::function<void(const Part*, Trees& trees, const std::vector<std::size_t>& onGround)>& visitor) {
    if (!_file)
        return visitor(nullptr, _memory, _onGround);
    flush();
    Trees().swap(_memory);
    Trees trees;
    std::vector<std::size_t> onGround;
    for (const Part& part : _parts)
        if (load(part, trees, onGround))
            visitor(&part, trees, onGround);
}

} // namespace osgTreeWind
