// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>

#include <osgTreeWind/base/AtomicFile.h>
#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/system/Path.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <unordered_map>

namespace {

using namespace osgTreeWind;

struct MergeOptions {
    std::vector<std::string> parts;
    std::string output, world;
};

/// Joins the tables of parts of a world: in the order of the parts, or sorted by the column `time` if there
/// is one.
class MergedTable {
public:
    explicit MergedTable(std::ostream& output) : _output(output) {}

    /// Adds the table of a part. @return why it cannot be added; empty on success.
    Diagnostics add(const std::string& file) {
        const Result<std::string> text = readTextFile(file);
        if (!text)
            return text.problems();
        Diagnostics problems;
        const auto addFittingRow = [&](const CsvTable& table, CsvTable::Row& row) {
            if (problems.empty() && hasSameColumns(table, problems))
                addRow(table, row, problems);
        };
        const Result<CsvTable> read = readCsvRows(text.value(), file, ',', addFittingRow);
        if (!read)
            return read.problems();
        if (problems.empty())
            hasSameColumns(read.value(), problems); // also for a part without rows
        ++_parts;
        return problems;
    }

    /// Writes the rows that are sorted by time. @return number of rows.
    std::size_t finish() {
        std::stable_sort(_byTime.begin(), _byTime.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [time, line] : _byTime)
            _output << line;
        return _rows;
    }
    bool hasOneRowPerTree() const { return !_columns.empty() && !_time; }

private:
    /// The first part sets the columns; all others must have the same ones.
    bool hasSameColumns(const CsvTable& table, Diagnostics& problems) {
        if (_columns.empty()) {
            _time = table.column("time");
            const auto tree = table.column(_time ? "name" : "id");
            if (!tree)
                return addProblem(problems, table,
                                  "expected a table of risk or of simulate --damage, found the columns " +
                                      csvLine(table.columns));
            _tree = *tree;
            _columns = table.columns;
            _output << csvLine(_columns);
        }
        return table.columns == _columns ||
               addProblem(problems, table, "expected the columns of the first part, " + csvLine(_columns));
    }

    void addRow(const CsvTable& table, const CsvTable::Row& row, Diagnostics& problems) {
        const std::string& tree = row.cells[_tree];
        const auto [known, isNew] = _partOfTree.emplace(tree, _parts);
        if (!isNew && !tree.empty() && (!_time || known->second != _parts))
            addProblem(problems, table,
                       "the tree " + tree +
                           " already has a row; give each part once, without overlapping --tiles",
                       row.line);
        ++_rows;
        if (!_time) {
            _output << csvLine(row.cells);
            return;
        }
        const Result<double> time = table.number(row, *_time);
        problems.insert(problems.end(), time.problems().begin(), time.problems().end());
        _byTime.emplace_back(time ? time.value() : 0.0, csvLine(row.cells));
    }

    /// Always returns false.
    static bool addProblem(Diagnostics& problems, const CsvTable& table, std::string message, int line = 0) {
        if (message.back() == '\n')
            message.pop_back();
        problems.push_back(fileProblem(table.file, message, line ? line : table.headerLine));
        return false;
    }

    std::ostream& _output;
    std::vector<std::string> _columns;
    std::optional<std::size_t> _time;
    std::size_t _tree = 0, _rows = 0;
    std::uint32_t _parts = 0;
    std::unordered_map<std::string, std::uint32_t> _partOfTree;
    std::vector<std::pair<double, std::string>> _byTime;
};

/// Number of trees in a world.
std::size_t treesOf(const std::string& world) {
    const ForestDescription forest = valueOrThrow(readForestFile(world));
    if (!forest.tiles)
        throw CommandError{
            BadInput, world + ": expected a world (made by osgtreewind tile), found a forest without tiles"};
    return forest.tiles->treeCount() - forest.tiles->removed.size() + forest.trees.size();
}

void run(const MergeOptions& options) {
    const std::size_t trees = options.world.empty() ? 0 : treesOf(options.world);
    checkOutputPath(options.output);
    AtomicFile whole(options.output);
    std::ofstream output(toPath(whole.writePath()), std::ios::binary);
    MergedTable table(output);
    for (const std::string& part : options.parts)
        throwIfAny(table.add(part));
    const std::size_t rows = table.finish();
    if (!options.world.empty() && (!table.hasOneRowPerTree() || rows != trees))
        throw CommandError{
            BadInput, options.world + ": expected a row for each of its " + std::to_string(trees) +
                          " trees, found " +
                          (table.hasOneRowPerTree() ? std::to_string(rows) : "a table of simulate --damage")};
    output.close();
    if (!output || !whole.commit())
        throwWriteError(whole);
    std::cout << rows << " rows in " << options.output << '\n';
}

} // namespace

void addMergeCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand("merge", "Merge the tables computed for parts of a world");
    auto options = std::make_shared<MergeOptions>();
    command
        ->add_option("parts", options->parts,
                     "CSV files of risk or of simulate --damage, one for each part (--tiles)")
        ->required();
    command->add_option("-o,--output", options->output, "Merged CSV file")->required();
    command->add_option("--world", options->world,
                        "World file (world.treewind): refuse tables of risk that lack some of its trees");
    command->footer(
        "Rows keep the order of the parts; rows of simulate --damage are sorted by time. All parts need\n"
        "the same columns, and a tree may be in one part only.\n"
        "Example: osgtreewind merge 0.csv 1.csv 2.csv -o risk.csv --world world/world.treewind");
    command->callback([options] { run(*options); });
}
