// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/output/Ending.h>

#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TiledForest.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

// Each command adds itself to the program.
void addInfoCommand(CLI::App& app);
void addValidateCommand(CLI::App& app);
void addRenderCommand(CLI::App& app);
void addSimulateCommand(CLI::App& app);
void addSwayCommand(CLI::App& app);
void addStormCommand(CLI::App& app);
void addRiskCommand(CLI::App& app);
void addPortraitCommand(CLI::App& app);
void addBenchCommand(CLI::App& app);
void addWindCommand(CLI::App& app);
void addTileCommand(CLI::App& app);
void addCanopyCommand(CLI::App& app);
void addMergeCommand(CLI::App& app);
void addViewCommand(CLI::App& app);

/// Adds --season: a word, number or date (species/Season.h).
void addSeasonOption(CLI::App& command, std::optional<float>& season);

/// Finite numbers from `low` to `high`; CLI::Range lets "nan" through.
CLI::Validator between(double low, double high);

/// Adds --tiles: which of a world's.
void addTilesOption(CLI::App& command, osgTreeWind::TileBox& tiles);

/// Says on standard error what is worth knowing of a file.
void printNotes(const std::string& file, const std::vector<std::string>& notes);

/// Ends the command where something stands at an output's place that is no file.
void checkIsFree(const std::string& output);

/// Reads the forest in `file` and prints its notes on standard error. The command ends if it cannot be read.
/// @param tiles of a world whose trees are wanted: there are no tiles in what comes out.
/// @param withNodes it is going to be drawn, and there must be memory for that.
osgTreeWind::ForestDescription loadForest(const std::string& file, const osgTreeWind::TileBox& tiles = {},
                                          bool withNodes = false);

/// What one run does of a world, so that many runs do all of it.
struct ForestPart {
    osgTreeWind::ForestDescription forest;
    std::size_t wanted = 0; ///< Trees that are asked for, the first ones; others stand around them.
};
/// As loadForest(), with the trees around those tiles that shelter trees in them.
ForestPart loadPart(const std::string& file, const osgTreeWind::TileBox& tiles);
