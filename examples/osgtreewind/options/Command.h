// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/output/CommandError.h>

#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TiledForest.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

// Each function adds one command to the program.
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

/// Adds --season: a word, a number or a date (species/Season.h).
void addSeasonOption(CLI::App& command, std::optional<float>& season);

/// Accepts finite numbers from `low` to `high`. (CLI::Range accepts "nan".)
CLI::Validator between(double low, double high);

/// Adds --tiles: the tiles of a world to read.
void addTilesOption(CLI::App& command, osgTreeWind::TileBox& tiles);

/// Prints notes about a file to standard error.
void printNotes(const std::string& file, const std::vector<std::string>& notes);

/// Throws CommandError if the output path exists and is not a regular file.
void checkOutputPath(const std::string& output);

/// Reads the forest in `file` and prints its notes to standard error. Throws CommandError on failure.
/// @param tiles tiles of a world to load; the result has plain trees and no tiles.
/// @param withNodes also check that there is enough memory to draw the forest.
osgTreeWind::ForestFile loadForest(const std::string& file, const osgTreeWind::TileBox& tiles = {},
                                   bool withNodes = false);

/// The part of a world that one run computes.
struct ForestPart {
    osgTreeWind::ForestFile forest;
    std::size_t requested = 0; ///< Number of requested trees. They come first; the others only shelter them.
};
/// Like loadForest(), with the trees around the tiles that shelter trees in them.
ForestPart loadPart(const std::string& file, const osgTreeWind::TileBox& tiles);
