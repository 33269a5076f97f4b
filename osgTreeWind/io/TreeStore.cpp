// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/TreeStore.h>

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace osgTreeWind {

namespace {

/// A tree as bytes; its name follows.
struct StoredTree {
    glm::dvec3 position;
    std::uint64_t species;
    TreeSize size;
    float heading, leaves;
    std::uint32_t seed, nameLength;
    bool openGrown, onGround, heightEstimated, trunkEstimated, crownEstimated;
};
static_assert(std::is_trivially_copyable_v<StoredTree>);

void append(std::string& bytes, const TreePlacement& tree, bool onGround) {
    StoredTree row;
    std::memset(static_cast<void*>(&row), 0, sizeof row); // no bytes of old memory in a file
    row.position = tree.position;
    row.species = tree.species;
    row.size = tree.size;
    row.heading = tree.heading;
    row.leaves = tree.leaves;
    row.seed = tree.seed;
    row.nameLength = static_cast<std::uint32_t>(tree.name.size());
    row.openGrown = tree.openGrown;
    row.onGround = onGround;
    row.heightEstimated = tree.estimated.height;
    row.trunkEstimated = tree.estimated.trunkDiameter;
    row.crownEstimated = tree.estimated.crownWidth;
    bytes.append(reinterpret_cast<const char*>(&row), sizeof row).append(tree.name);
}

/// @return where the next one begins.
const char* take(const char* bytes, TreePlacement& tree, bool& onGround) {
    StoredTree row;
    std::memcpy(static_cast<void*>(&row), bytes, sizeof row);
    tree.position = row.position;
    tree.species = static_cast<std::size_t>(row.species);
    tree.size = row.size;
    tree.heading = row.heading;
    tree.leaves = row.leaves;
    tree.seed = row.seed;
    tree.openGrown = row.openGrown;
    tree.estimated = {row.heightEstimated, row.trunkEstimated, row.crownEstimated};
    tree.name.assign(bytes + sizeof row, row.nameLength);
    onGround = row.onGround;
    return bytes + sizeof row + row.nameLength;
}

std::string bytesOf(const TreeStore::Trees& trees, const std::vector<std::size_t>& onGround) {
    std::string bytes;
    bytes.reserve(trees.size() * (sizeof(StoredTree) + 8));
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

bool TreeStore::useFile(const std::string& folder, std::size_t most) {
    const std::string path = folder + "/trees.part";
    _file.reset(std::fopen(path.c_str(), "w+b"));
    if (_file)
        std::remove(path.c_str());
    _most = most;
    return _file != nullptr;
}

void TreeStore::add(const TreePlacement& tree, bool onGround) {
    if (onGround)
        _onGround.push_back(_memory.size());
    _memory.push_back(tree);
    if (_file && _memory.size() >= _most)
        store();
}

void TreeStore::store() {
    if (!_file || _memory.empty())
        return;
    const std::string bytes = bytesOf(_memory, _onGround);
    Part part;
    if (!_parts.empty())
        part.begin = _parts.back().begin + static_cast<long>(_parts.back().bytes);
    part.trees = _memory.size();
    part.bytes = bytes.size();
    write(part, bytes);
    _parts.push_back(part);
    _stored += part.trees;
    _memory.clear();
    _onGround.clear();
}

void TreeStore::write(const Part& part, const std::string& bytes) {
    if (bytes.size() != part.bytes || std::fseek(_file.get(), part.begin, SEEK_SET) != 0 ||
        std::fwrite(bytes.data(), 1, bytes.size(), _file.get()) != bytes.size() ||
        std::fflush(_file.get()) != 0)
        _failed = true;
}

bool TreeStore::load(const Part& part, Trees& trees, std::vector<std::size_t>& onGround) {
    std::string bytes(part.bytes, '\0');
    if (_failed || std::fseek(_file.get(), part.begin, SEEK_SET) != 0 ||
        std::fread(bytes.data(), 1, bytes.size(), _file.get()) != bytes.size()) {
        _failed = true;
        return false;
    }
    trees.resize(part.trees);
    onGround.clear();
    const char* next = bytes.data();
    for (std::size_t i = 0; i < trees.size(); ++i) {
        bool isOnGround = false;
        next = take(next, trees[i], isOnGround);
        if (isOnGround)
            onGround.push_back(i);
    }
    return true;
}

void TreeStore::visit(const std::function<void(const Trees&)>& take) {
    eachPart([&](const Part*, Trees& trees, const std::vector<std::size_t>&) { take(trees); });
}

void TreeStore::change(
    const std::function<void(Trees& trees, const std::vector<std::size_t>& onGround)>& change) {
    eachPart([&](const Part* part, Trees& trees, const std::vector<std::size_t>& onGround) {
        change(trees, onGround);
        if (part)
            write(*part, bytesOf(trees, onGround));
    });
}

void TreeStore::eachPart(
    const std::function<void(const Part*, Trees& trees, const std::vector<std::size_t>& onGround)>& use) {
    if (!_file)
        return use(nullptr, _memory, _onGround);
    store();
    Trees().swap(_memory);
    Trees trees;
    std::vector<std::size_t> onGround;
    for (const Part& part : _parts)
        if (load(part, trees, onGround))
            use(&part, trees, onGround);
}

} // namespace osgTreeWind
