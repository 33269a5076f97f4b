// SPDX-License-Identifier: MIT
#include <tests/Folders.h>
#include <tests/base/IsProblem.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/growth/GrowthKeys.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/model/TreeKeys.h>
#include <osgTreeWind/species/SpeciesKeys.h>
#include <osgTreeWind/wind/WindKeys.h>

#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <type_traits>

namespace osgTreeWind {

namespace {

std::string manual() {
    std::ifstream file(OSGTREEWIND_SOURCE_DIR "/docs/treewind.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The ```toml blocks of the manual.
std::vector<std::string> examplesOf(const std::string& text) {
    const std::string open = "```toml\n", close = "```\n";
    std::vector<std::string> examples;
    for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
        at += open.size();
        const std::size_t end = text.find(close, at);
        examples.push_back(text.substr(at, end - at));
        at = end + close.size();
    }
    return examples;
}

bool needsFile(const std::string& example) {
    return example.rfind("# needs a file", 0) == 0;
}

/// All keys that the reader reads in any section.
std::set<std::string> knownKeys() {
    const TemporaryFolder folder;
    folder.write("a.csv", "t\n1\n");
    const std::string everySection =
        "version = 1\n[ground]\n[motion]\n[drawing]\n[[tree]]\n[tree.estimated]\n[scatter]\nheight = "
        "1\n[inventory]\nfile = "
        "\"a.csv\"\n[inventory.columns]\n"
        "[inventory.units]\n[[species]]\n[species.tree]\n\n[species.leaves]\n[species.height]\n[species."
        "crown]\n[species.wood]"
        "\n[species."
        "branch]\n"
        "[species.leaf]\n[species.appearance]\n[tiles]\ncolumns = 1\nrows = 1\ntrees = [[0]]\nlow = "
        "[[0]]\nhigh = [[0]]\n[[wind.source]]\n[wind]\n";
    std::set<std::string> keys;
    for (const char* form : {"habit", "palm"}) {
        ForestReading reading;
        TableReader::readDocument(std::string("version = 1\n[[species]]\n[species.") + form + "]\n",
                                  reading.log, [&](TableReader& root) { readRoot(root, reading); });
        keys.insert(reading.log.keys.begin(), reading.log.keys.end());
    }
    for (const char* wind :
         {"kind = \"calm\"", "kind = \"uniform\"", "kind = \"gusts\"\nheight = 1", "kind = \"file\"",
          "kind = \"grid\"\nvalues = [0]", "kind = \"grid\"\nfile = \"a.csv\"",
          "kind = \"forest_wind\"\nvalues = [0]", "kind = \"series\"\nheight = 1",
          "kind = \"series\"\nfile = \"a.csv\"\n[wind.columns]"}) {
        ForestReading reading;
        reading.folders = InputFolders(folder.path());
        TableReader::readDocument(everySection + wind, reading.log,
                                  [&](TableReader& root) { readRoot(root, reading); });
        keys.insert(reading.log.keys.begin(), reading.log.keys.end());
    }
    return keys;
}

/// Type, range and default of a each, formatted for the manual.
struct ManualCells {
    const Key& each;
    std::string type, range, value;

    ManualCells(const Key& described, const void* defaults) : each(described) {
        range = each.range.text();
        range = range.substr(range.rfind("in ", 0) == 0 ? 3 : 0);
        std::visit(*this, each.of(defaults));
        if (each.doc.find("without it") != std::string::npos)
            value.clear(); // the description gives the default
        type += each.unit.empty() || each.unit == "file" ? "" : ", " + each.unit;
    }

    static std::string rounded(double number) {
        char text[32];
        std::snprintf(text, sizeof text, "%.3g", number);
        return numberText(std::stod(text));
    }
    void operator()(const bool* member) { type = "true or false", value = *member ? "true" : "false"; }
    template <typename T>
    void operator()(const std::optional<T>*) {
        const T none{};
        (*this)(&none);
        value.clear();
    }
    void operator()(const int* member) { type = "whole number", value = std::to_string(*member); }
    void operator()(const std::uint32_t* member) {
        type = "whole number", range = "[0, 4294967295]", value = std::to_string(*member);
    }
    void operator()(const float* member) {
        const double number = static_cast<double>(*member);
        type = "number";
        if (memberRange(each).contains(number)) // otherwise the default means "not given"
            value = rounded(each.degrees() ? glm::degrees(number) : number);
    }
    void operator()(const double* member) { type = "number", value = rounded(*member); }
    template <typename Number>
    void operator()(const glm::vec<3, Number>* member) {
        type = std::is_integral_v<Number> ? "array of 3 whole numbers" : "array of 3 numbers";
        range = "each " + range;
        value = "`[" + rounded(static_cast<double>(member->x)) + ", " +
                rounded(static_cast<double>(member->y)) + ", " + rounded(static_cast<double>(member->z)) +
                "]`";
    }
    void operator()(const std::array<float, 4>* member) {
        type = "array of 4 numbers", range = "each " + range;
        for (const float number : *member)
            value += (value.empty() ? "`[" : ", ") +
                     rounded(static_cast<double>(each.degrees() ? glm::degrees(number) : number));
        value += "]`";
    }
    void operator()(const std::string*) { type = "text"; }
    template <typename Number>
    void operator()(const std::vector<Number>*) {
        type = "array of numbers", range = "each " + range;
    }
    void operator()(const std::vector<glm::vec3>*) {
        type = "array of arrays of 3 numbers", range = "each " + range;
    }
    void operator()(const std::vector<std::string>*) { type = "array of texts", value = "`[]`"; }
    void operator()(const EnumMember& word) {
        type = "text";
        for (const auto& [text, number] : each.words) {
            range += (range.empty() ? "`\"" : ", `\"") + text + "\"`";
            if (number == word.get(word.object))
                value = "`\"" + text + "\"`";
        }
    }
    void operator()(const NestedMember&) { type = "table"; }
};

/// The cell "default" for required keys.
const std::map<std::string, std::string>& requiredKeys() {
    static const std::map<std::string, std::string> keys = {{"wind.source.kind", "required"},
                                                            {"wind.source.place", "this or `position`"}};
    return keys;
}

std::string rowOf(const std::vector<std::string>& cells) {
    std::string row = "|";
    for (const std::string& cell : cells)
        row += cell.empty() ? " |" : ' ' + cell + " |";
    return row;
}

/// Adds a row for each each, including nested ones. @param tables with these keys, and defaults.
void addRows(std::vector<std::string>& rows, const Keys& keys,
             const std::vector<std::pair<std::string, const void*>>& tables) {
    std::map<const Keys*, std::vector<std::pair<std::string, const void*>>> parts;
    for (const Key& each : keys) {
        std::string keys, values;
        std::set<std::string> distinct;
        for (const auto& [table, defaults] : tables) {
            const ManualCells cells(each, defaults);
            const std::string key = (table.empty() ? "" : table + '.') + each.name;
            keys += (keys.empty() ? "`" : ", `") + key + '`';
            const auto required = requiredKeys().find(key);
            const std::string& value = required != requiredKeys().end() ? required->second : cells.value;
            if (distinct.insert(value).second)
                values += (values.empty() ? "" : ", ") + value;
            if (const Member member = each.of(defaults); const auto part = std::get_if<NestedMember>(&member))
                parts[part->keys].push_back({key, part->object});
        }
        const ManualCells cells(each, tables.front().second);
        if (cells.type != "table")
            rows.push_back(rowOf({keys, cells.type, cells.range, values, each.doc}));
    }
    for (const auto& [partFields, partTables] : parts)
        addRows(rows, *partFields, partTables);
}

template <typename Struct>
void addRows(std::vector<std::string>& rows, const std::string& table) {
    const Struct defaults{};
    addRows(rows, keysOf<Struct>(), {{table, &defaults}});
}

} // namespace

/// Updates the manual if the environment variable OSGTREEWIND_WRITE_MANUAL is set.
TEST(DocumentedKeys, ManualMatchesTheFields) {
    std::vector<std::string> rows;
    addRows<WindGusts>(rows, "wind");
    addRows<WindClock>(rows, "wind");
    addRows<WindAdjustment>(rows, "wind");
    addRows<WindSource>(rows, "wind.source");
    addRows<CanopySettings>(rows, "wind");
    const ForestDescription forest;
    addRows(rows, forestFileKeys(), {{"", &forest}});
    addRows<ForestDescription>(rows, "motion");
    addRows<DrawingOptions>(rows, "drawing");
    addRows<Species>(rows, "species");
    addRows<RecursiveTreeParameters>(rows, "species.tree");
    addRows<PalmParameters>(rows, "species.palm");
    addRows<GrowthParameters>(rows, "species.habit");
    addRows<LeafParameters>(rows, "species.leaves");
    addRows<TreePlacement>(rows, "tree");
    std::string text = manual();
    for (const std::string& row : rows) {
        const std::size_t at = text.find(row.substr(0, row.find(" | ") + 3));
        ASSERT_NE(at, std::string::npos) << row << " is not in the manual";
        std::size_t end = text.find('\n', at);
        if (std::getenv("OSGTREEWIND_WRITE_MANUAL"))
            text.replace(at, end - at, row), end = at + row.size();
        EXPECT_EQ(text.substr(at, end - at), row);
    }
    if (std::getenv("OSGTREEWIND_WRITE_MANUAL"))
        std::ofstream(OSGTREEWIND_SOURCE_DIR "/docs/treewind.md") << text;
}

TEST(DocumentedKeys, EveryKeyOfTheReaderIsDocumented) {
    const std::string text = manual();
    const std::set<std::string> keys = knownKeys();
    EXPECT_GT(keys.size(), 100u);
    for (const std::string& key : keys)
        EXPECT_TRUE(hasPart(text, '`' + key + '`')) << key << " is not documented";
}

TEST(DocumentedKeys, EveryKeyOfTheManualIsRead) {
    const std::set<std::string> keys = knownKeys();
    std::istringstream lines(manual());
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("| `", 0) != 0)
            continue;
        const std::string cell = line.substr(0, line.find('|', 2));
        for (std::size_t at = cell.find('`'); at != std::string::npos; at = cell.find('`', at + 1)) {
            const std::size_t end = cell.find('`', at + 1);
            const std::string key = cell.substr(at + 1, end - at - 1);
            EXPECT_TRUE(keys.count(key)) << key << " is documented but not read";
            at = end;
        }
    }
}

TEST(DocumentedKeys, EveryExampleOfTheManualReads) {
    const std::vector<std::string> examples = examplesOf(manual());
    EXPECT_GT(examples.size(), 8u);
    for (const std::string& example : examples) {
        std::istringstream input(example);
        const auto result = readForest(input, {"treewind.md", "/nowhere"});
        if (result.ok())
            continue;
        for (const Diagnostic& problem : result.problems())
            EXPECT_TRUE(needsFile(example) && problem.message.find("no file") == 0)
                << problem.text() << " in\n"
                << example;
    }
}

} // namespace osgTreeWind
