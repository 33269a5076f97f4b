// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/WholeFile.h>
#include <osgTreeWind/forest/ForestFields.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TomlEdit.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>

namespace osgTreeWind {

namespace {

/// Of a document as writeForest() writes it, where each key has a line: tables by name, those of
/// [[wind.source]] as one.
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

/// What a person steers while a forest runs; "" is the document itself.
const std::vector<std::string> steeredTables = {"", "wind", "motion", "drawing"};

std::optional<std::string> written(ForestDescription forest) {
    forest.trees.clear();
    std::ostringstream text;
    return writeForest(forest, text).empty() ? std::optional(text.str()) : std::nullopt;
}

/// Whether a Forest of those that were read has those of now: it rounds their places.
bool sameTrees(const ForestDescription& read, const ForestDescription& now) {
    const auto same = [&](const TreePlacement& tree, const TreePlacement& other) {
        const auto differs = [&](const Field& field) { return !sameField(field, &tree, &other); };
        const Fields& fields = fieldsOf<TreePlacement>();
        return tree.species == other.species && tree.name == other.name &&
               glm::vec3(tree.position - read.origin) == glm::vec3(other.position - now.origin) &&
               std::none_of(fields.begin(), fields.end(), differs);
    };
    return std::equal(read.trees.begin(), read.trees.end(), now.trees.begin(), now.trees.end(), same);
}

/// The document with what is said otherwise now; nothing where it cannot be said so.
std::optional<std::string> edited(const std::string& document, const ForestDescription& read,
                                  const ForestDescription& now, const std::string& path) {
    const std::optional<std::string> before = written(read), after = written(now);
    if (!before || !after || read.tiles || now.tiles || !sameTrees(read, now))
        return std::nullopt;
    WrittenSections old(*before), wanted(*after);
    const auto saysSo = [&](const std::string& text) {
        std::istringstream input(text);
        const auto again = readForest(input, {path, std::filesystem::path(path).parent_path().string()});
        return again && sameTrees(again.value(), now) && written(again.value()) == after;
    };
    TomlEdit keys(document);
    for (const std::string& table : steeredTables) {
        for (const auto& [key, value] : wanted.values[table])
            if (const auto was = old.values[table].find(key);
                was == old.values[table].end() || was->second != value)
                keys.set(table, key, value);
        for (const auto& [key, value] : old.values[table])
            if (!wanted.values[table].count(key))
                keys.remove(table, key);
    }
    if (old.lines["wind.source"] != wanted.lines["wind.source"])
        keys.replaceTables("wind.source", wanted.lines["wind.source"]);
    if (saysSo(keys.text()))
        return keys.text();
    keys.replaceTables("wind", wanted.lines["wind"] + wanted.lines["wind.source"]);
    return saysSo(keys.text()) ? std::optional(keys.text()) : std::nullopt;
}

} // namespace

Diagnostics editForestFile(const ForestDescription& now, const std::string& from, const std::string& path) {
    const Result<std::string> document = readTextFile(from);
    const auto read = readForestFile(from);
    const std::optional<std::string> text =
        document && read ? edited(document.value(), read.value(), now, path) : std::nullopt;
    if (!text)
        return writeForestFile(now, path);
    return writeWholeFile(path, *text);
}

} // namespace osgTreeWind
