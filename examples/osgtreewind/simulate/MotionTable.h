// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/ForestSimulation.h>

#include <functional>
#include <string>
#include <vector>

/// A column of numbers. Vectors have the axes of the scene: x east, y north, z up.
struct MotionColumn {
    std::string name;
    std::string unit;     ///< As in the CF conventions.
    std::string words;    ///< Meaning and sign.
    bool isPlace = false; ///< Metres in the scene; CSV has six decimals instead of six digits.
    bool isFixed = false; ///< Does not change with time.
};

/// What the command `simulate` writes at each step: a row for each tree or for each of some of its units.
struct MotionTable {
    /// Computes the present values of a tree: all columns of its first row, then of the next. Values that do
    /// not exist are NaN. Different threads may call it for different trees.
    using Fill =
        std::function<void(const osgTreeWind::ForestSimulation&, osgTreeWind::TreeId, float* values)>;

    std::string title;
    bool isOfUnits = false;            ///< Rows are units; otherwise trees.
    bool hasLevels = false;            ///< CSV has the column `level`, the branching order of the unit.
    std::vector<MotionColumn> columns; ///< After time, tree and, for units, unit and level; before id.
    std::vector<osgTreeWind::TreeId> trees;
    std::vector<std::size_t> units;     ///< Units of each tree; empty: all.
    std::vector<std::size_t> firstRows; ///< The first row of each tree, then the number of rows.
    Fill fill;

    std::size_t rowCount() const { return firstRows.back(); }
    std::size_t unitOf(std::size_t row, std::size_t tree) const {
        return units.empty() ? row - firstRows[tree] : units[row - firstRows[tree]];
    }
    /// The present values of the trees [first, end), row by row, computed by the threads of the simulation.
    void values(const osgTreeWind::ForestSimulation& simulation, std::size_t first, std::size_t end,
                std::vector<float>& result) const;
};

/// Angles and wind of all units, and the places of their tips if `tips`.
MotionTable branchTable(const osgTreeWind::ForestSimulation& simulation,
                        const std::vector<osgTreeWind::TreeId>& trees, bool tips);
/// The places of treetops, now and at rest.
MotionTable topTable(const osgTreeWind::ForestSimulation& simulation,
                     const std::vector<osgTreeWind::TreeId>& trees);
/// TreeSway of each tree; law `modal` only.
MotionTable loadTable(const std::vector<osgTreeWind::TreeId>& trees);
/// BranchLoad of the units with these numbers; law `modal` only. Throws CommandError if a tree lacks one.
MotionTable unitLoadTable(const osgTreeWind::ForestSimulation& simulation,
                          const std::vector<osgTreeWind::TreeId>& trees,
                          const std::vector<std::size_t>& units);
