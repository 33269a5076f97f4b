// SPDX-License-Identifier: MIT
#pragma once

#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/io/ForestFile.h>

#include <gtest/gtest.h>

#include <sstream>

namespace osgTreeWind {

inline const std::string utm = "urn:ogc:def:crs:EPSG::25832";
inline const std::string xy = "columns = { x = \"x\", y = \"y\" }\n";

/// Reads a forest with one [inventory] of these lines, with the default species beech.
inline Result<ForestFile> readInventoryOf(const std::string& folder, const std::string& lines,
                                          const std::string& head = "") {
    std::istringstream input("version = 1\n" + head + "\n[inventory]\ndefault_species = \"beech\"\n" + lines);
    return readForest(input, {"test.treewind", folder});
}

/// The same; problems are test failures.
inline ForestFile inventoryOf(const std::string& folder, const std::string& lines,
                              const std::string& head = "") {
    const auto forest = readInventoryOf(folder, lines, head);
    for (const Diagnostic& problem : forest.problems())
        ADD_FAILURE() << problem.text();
    return forest.value();
}

inline void expectAt(const TreePlacement& tree, double x, double y, double tolerance = 1e-3) {
    EXPECT_NEAR(tree.position.x, x, tolerance);
    EXPECT_NEAR(tree.position.y, y, tolerance);
}

/// All notes, one per line.
inline std::string notesOf(const ForestFile& forest) {
    std::string all;
    for (const std::string& note : forest.notes)
        all += note + '\n';
    return all;
}

} // namespace osgTreeWind
