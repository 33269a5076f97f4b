// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <CLI/CLI.hpp>

#include <string>

/// A built-in species, or FILE.treewind:NAME. Throws CommandError if there is no such species.
osgTreeWind::Species speciesByName(const std::string& name);

/// A tree described by command-line options.
struct TreeRecord {
    std::string species = "broadleaf";
    double diameter = 0.0, height = 0.0, crownWidth = 0.0; ///< cm and m; 0 if not given.
    double leaves = 1.0;                                   ///< Share of the leaves on the tree.
    bool open = false;

    /// Makes a placement, and sets the sizes that were not given to those of the resulting tree.
    osgTreeWind::TreePlacement makePlacement(const osgTreeWind::Species& kind);
};

/// Adds --species, --dbh, --height, --crown-width, --open and --leaves.
void addTreeOptions(CLI::App& command, TreeRecord& tree);
