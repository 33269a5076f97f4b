// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/AtomicFile.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TomlEdit.h>
#include <osgTreeWind/system/Path.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>

namespace osgTreeWind {

namespace {

/// The tables of a document by writeForest(), with a line per key. All [[wind.source]] count as one table.
struct WrittenSections {
    std::map<std::string, std::map<std::string, std::string>> values;
    std::map<std::string, std::string> lines;

    explicit WrittenSections(const std::string& text) {
        std::istringstream input(text);
        std::string table;
        for (std::string line; std::getline(input, line);) {
            if (line.empty())
                continue;
            if (line.front() == '[')
                table = line.substr(0, line.find(']')).erase(0, line.find_first_not_of('['));
            else if (const std::size_t equals = line.find(" = "); equals != std::string::npos)
                values[table][line.substr(0, equals)] = line.substr(equals + 3);
            lines[table] += line + '\n';
        }
    }
};

/// Tables with settings that users change in a running forest; "" is the root table.
const std::vector<std::string> editableTables = {"", "wind", "motion", "drawing"};

std::optional<std::string> writtenText(ForestDescription forest) {
    forest.trees.clear();
    std::ostringstream text;
    return writeForest(forest, text).empty() ? std::optional(text.str()) : std::nullopt;
}

/// Whether both have the same trees. Positions may differ by the rounding of a Forest.
bool areTreesEqual(const ForestDescription& read, const ForestDescription& now) {
    const auto isEqual = [&](const TreePlacement& tree, const TreePlacement& other) {
        const auto differs = [&](const Key& key) { return !isKeyEqual(key, &tree, &other); };
        const Keys& members = keysOf<TreePlacement>();
        return tree.species == other.species && tree.name == other.name &&
               glm::vec3(tree.position - read.origin) == glm::vec3(other.position - now.origin) &&
               std::none_of(members.begin(), members.end(), differs);
    };
    return std::equal(read.trees.begin(), read.trees.end(), now.trees.begin(), now.trees.end(), isEqual);
}

/// The document with edits that make it describe the forest `now`; empty if edits cannot do that.
std::optional<std::string> editedText(const std::string& document, const ForestDescription& read,
                                      const ForestDescription& now, const std::string& path) {
    const std::optional<std::string> before = writtenText(read), after = writtenText(now);
    if (!before || !after || read.tiles || now.tiles || !areTreesEqual(read, now))
        return std::nullopt;
    WrittenSections old(*before), wanted(*after);
    const auto readsBack = [&](const std::string& text) {
        std::istringstream input(text);
        const auto again = readForest(input, {path, folderOf(path)});
        return again && areTreesEqual(again.value(), now) && writtenText(again.value()) == after;
    };
    TomlEdit keys(document);
    for (const std::string& table : editableTables) {
        for (const auto& [key, value] : wanted.values[table])
            if (const auto previous = old.values[table].find(key);
                previous == old.values[table].end() || previous->second != value)
                keys.set(table, key, value);
        for (const auto& [key, value] : old.values[table])
            if (!wanted.values[table].count(key))
                keys.remove(table, key);
    }
    if (old.lines["wind.source"] != wanted.lines["wind.source"])
        keys.replaceTables("wind.source", wanted.lines["wind.source"]);
    if (readsBack(keys.text()))
        return keys.text();
    keys.replaceTables("wind", wanted.lines["wind"] + wanted.lines["wind.source"]);
    return readsBack(keys.text()) ? std::optional(keys.text()) : std::nullopt;
}

} // namespace

Diagnostics editForestFile(const ForestDescription& forest, const std::string& from,
                           const std::string& path) {
    const Result<std::string> document = readTextFile(from);
    const auto read = readForestFile(from);
    const std::optional<std::string> text =
        document && read ? editedText(document.value(), read.value(), forest, path) : std::nullopt;
    if (!text)
        return writeForestFile(forest, path);
    return writeFileAtomically(path, *text);
}

} // namespace osgTreeWind
