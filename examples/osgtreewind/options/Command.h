// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TiledForest.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

/// How a command ended; the exit status of the program.
enum ExitCode { Succeeded = 0, Failed = 1, BadInput = 2 };

// Each command adds itself to the program and, when it was the one asked for, sets `exitCode`.
void addInfoCommand(CLI::App& app, ExitCode& exitCode);
void addValidateCommand(CLI::App& app, ExitCode& exitCode);
void addRenderCommand(CLI::App& app, ExitCode& exitCode);
void addSimulateCommand(CLI::App& app, ExitCode& exitCode);
void addSwayCommand(CLI::App& app, ExitCode& exitCode);
void addStormCommand(CLI::App& app, ExitCode& exitCode);
void addRiskCommand(CLI::App& app, ExitCode& exitCode);
void addPortraitCommand(CLI::App& app, ExitCode& exitCode);
void addBenchCommand(CLI::App& app, ExitCode& exitCode);
void addWindCommand(CLI::App& app, ExitCode& exitCode);
void addTileCommand(CLI::App& app, ExitCode& exitCode);
void addCanopyCommand(CLI::App& app, ExitCode& exitCode);
void addMergeCommand(CLI::App& app, ExitCode& exitCode);
void addViewCommand(CLI::App& app, ExitCode& exitCode);

/// Adds --season: a word, number or date (species/Season.h).
void addSeasonOption(CLI::App& command, std::optional<float>& season);

/// Finite numbers from `low` to `high`; CLI::Range lets "nan" through.
CLI::Validator within(double low, double high);

/// Adds --tiles: which of a world's.
void addTilesOption(CLI::App& command, osgTreeWind::TileBox& tiles);

/// The forest in `file`; prints the problems, or what is worth knowing, on standard error.
/// @param tiles of a world whose trees are wanted: there are no tiles in what comes out.
/// @param withNodes it is going to be drawn, and there must be memory for that.
std::optional<osgTreeWind::ForestDescription>
loadForest(const std::string& file, const osgTreeWind::TileBox& tiles = {}, bool withNodes = false);

/// What one run does of a world, so that many runs do all of it.
struct ForestPart {
    osgTreeWind::ForestDescription forest;
    std::size_t wanted = 0; ///< Trees that are asked for, the first ones; others stand around them.
};
/// As loadForest(), with the trees around those tiles that shelter trees in them.
std::optional<ForestPart> loadPart(const std::string& file, const osgTreeWind::TileBox& tiles);
