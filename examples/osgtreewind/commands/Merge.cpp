// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>

#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/WholeFile.h>

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

/// Tables of parts of a world, one below the other, or by time where rows have one.
class MergedTable {
public:
    explicit MergedTable(std::ostream& output) : _output(output) {}

    /// All of a part. @return what keeps it from being one of them; empty where nothing does.
    Diagnostics add(const std::string& file) {
        const Result<std::string> text = readTextFile(file);
        if (!text)
            return text.problems();
        Diagnostics problems;
        const auto take = [&](const CsvTable& table, CsvTable::Row& row) {
            if (problems.empty() && fits(table, problems))
                takeRow(table, row, problems);
        };
        const Result<CsvTable> read = readCsvRows(text.value(), file, ',', take);
        if (!read)
            return read.problems();
        if (problems.empty())
            fits(read.value(), problems); // a part may have no rows
        ++_parts;
        return problems;
    }

    /// Writes what waits for the last part. @return how many rows there are.
    std::size_t finish() {
        std::stable_sort(_byTime.begin(), _byTime.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [time, line] : _byTime)
            _output << line;
        return _rows;
    }
    bool hasATreeARow() const { return !_columns.empty() && !_time; }

private:
    /// The first part says which columns there are.
    bool fits(const CsvTable& table, Diagnostics& problems) {
        if (_columns.empty()) {
            _time = table.column("time");
            const auto tree = table.column(_time ? "name" : "id");
            if (!tree)
                return fails(problems, table,
                             "expected a table of risk or of simulate --damage, found the columns " +
                                 csvLine(table.columns));
            _tree = *tree;
            _columns = table.columns;
            _output << csvLine(_columns);
        }
        return table.columns == _columns ||
               fails(problems, table, "expected the columns of the first part, " + csvLine(_columns));
    }

    void takeRow(const CsvTable& table, const CsvTable::Row& row, Diagnostics& problems) {
        const std::string& tree = row.cells[_tree];
        const auto [met, isNew] = _partOfTree.emplace(tree, _parts);
        if (!isNew && !tree.empty() && (!_time || met->second != _parts))
            fails(problems, table, "the tree " + tree + " is in another row already", row.line);
        ++_rows;
        if (!_time) {
            _output << csvLine(row.cells);
            return;
        }
        const Result<double> time = table.number(row, *_time);
        problems.insert(problems.end(), time.problems().begin(), time.problems().end());
        _byTime.emplace_back(time ? time.value() : 0.0, csvLine(row.cells));
    }

    static bool fails(Diagnostics& problems, const CsvTable& table, std::string message, int line = 0) {
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

/// How many trees a world has.
std::size_t treesOf(const std::string& world) {
    const ForestDescription forest = valueOf(readForestFile(world));
    if (!forest.tiles)
        throw Ending{BadInput, world + ": expected a world, found a forest without tiles"};
    return forest.tiles->treeCount() - forest.tiles->removed.size() + forest.trees.size();
}

void run(const MergeOptions& options) {
    const std::size_t trees = options.world.empty() ? 0 : treesOf(options.world);
    checkIsFree(options.output);
    WholeFile whole(options.output);
    std::ofstream output(whole.unfinished(), std::ios::binary);
    MergedTable table(output);
    for (const std::string& part : options.parts)
        if (const Diagnostics problems = table.add(part); !problems.empty())
            throw Ending{BadInput, problems.front().text()};
    const std::size_t rows = table.finish();
    if (!options.world.empty() && (!table.hasATreeARow() || rows != trees))
        throw Ending{BadInput, options.world + ": expected a row for each of its " + std::to_string(trees) +
                                   " trees, found " +
                                   (table.hasATreeARow() ? std::to_string(rows) : "a table of damage")};
    output.close();
    if (!output || !whole.putInPlace())
        endUnwritten(whole);
    std::cout << rows << " rows in " << options.output << '\n';
}

} // namespace

void addMergeCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand("merge", "Put tables of parts of a world together");
    auto options = std::make_shared<MergeOptions>();
    command
        ->add_option("parts", options->parts, "CSV files of risk, or of simulate --damage, of --tiles each")
        ->required();
    command->add_option("-o,--output", options->output, "A CSV file")->required();
    command->add_option("--world", options->world,
                        "world.treewind: refuse tables of risk that lack some of its trees");
    command->footer(
        "Rows come in the order of the parts, those of simulate --damage by time. Parts have the same\n"
        "columns, and no tree is in two of them.\n"
        "Example: osgtreewind merge 0.csv 1.csv 2.csv -o risk.csv --world world/world.treewind");
    command->callback([options] { run(*options); });
}
