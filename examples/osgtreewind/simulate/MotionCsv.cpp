// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/AtomicTable.h>
#include <examples/osgtreewind/output/Signals.h>
#include <examples/osgtreewind/simulate/MotionFile.h>

#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/forest/PlacedForest.h>

#include <charconv>
#include <cmath>

using namespace osgTreeWind;

namespace {

/// Appends a number with six digits, or six decimals.
void append(std::string& text, double number, bool isPlace = false, int precision = 6) {
    char cell[64];
    const auto end =
        std::to_chars(cell, cell + sizeof cell, number,
                      isPlace ? std::chars_format::fixed : std::chars_format::general, precision);
    text.append(cell, end.ptr);
}

class MotionCsv final : public MotionFile {
public:
    MotionCsv(const std::string& path, const MotionTable& table, const ForestSimulation& simulation)
        : _table(table), _simulation(simulation), _output(path) {
        std::string head = table.isOfUnits ? "time,tree,unit" : "time,tree";
        head += table.hasLevels ? ",level" : "";
        for (const MotionColumn& column : table.columns)
            head += ',' + column.name;
        put(head + ",id\n");
    }

    void write(double time) override {
        constexpr std::size_t rowsAtATime = 20000;
        std::string start;
        append(start, time, false, time < 1000.0 ? 6 : 10);
        for (std::size_t first = 0, end = 0; first < _table.trees.size(); first = end) {
            while (end < _table.trees.size() &&
                   (end == first || _table.firstRows[end + 1] - _table.firstRows[first] <= rowsAtATime))
                ++end;
            _table.values(_simulation, first, end, _values);
            std::string text;
            const float* values = _values.data();
            for (std::size_t tree = first; tree < end; ++tree)
                values = addRows(tree, start, values, text);
            put(text);
        }
    }

    void finish() override { _output.finish(); }

private:
    /// Appends the rows of a tree. @return the values after them.
    const float* addRows(std::size_t tree, const std::string& time, const float* value, std::string& text) {
        const TreeId id = _table.trees[tree];
        const std::string start = time + ',' + std::to_string(slotOfTree(id)),
                          end = ',' + csvCell(_simulation.nameOf(id)) + '\n';
        const Skeleton& skeleton = _simulation.skeleton(*_simulation.modelOf(id));
        for (std::size_t row = _table.firstRows[tree]; row < _table.firstRows[tree + 1]; ++row) {
            text += start;
            const std::size_t unit = _table.unitOf(row, tree);
            if (_table.isOfUnits)
                text += ',' + std::to_string(unit);
            if (_table.hasLevels)
                text += ',' + std::to_string(skeleton.units[unit].level);
            for (const MotionColumn& column : _table.columns) {
                text += ',';
                if (!std::isnan(*value))
                    append(text, static_cast<double>(*value), column.isPlace);
                ++value;
            }
            text += end;
        }
        return value;
    }

    /// Writes whole rows.
    void put(const std::string& text) {
        const WholeRow whole;
        std::fwrite(text.data(), 1, text.size(), _output.file());
        if (_output.file() == stdout)
            std::fflush(stdout);
        if (std::ferror(_output.file()))
            _output.finish(); // throws
    }

    const MotionTable& _table;
    const ForestSimulation& _simulation;
    AtomicTable _output;
    std::vector<float> _values;
};

} // namespace

std::unique_ptr<MotionFile> createMotionCsv(const std::string& path, const MotionTable& table,
                                            const ForestSimulation& simulation) {
    return std::make_unique<MotionCsv>(path, table, simulation);
}
