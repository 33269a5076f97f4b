// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/ShapeFamilies.h>
#include <osgTreeWind/io/DocumentSpecies.h>
#include <osgTreeWind/io/DocumentTrees.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/InputFolders.h>
#include <osgTreeWind/io/SceneMap.h>
#include <osgTreeWind/io/TableReader.h>
#include <osgTreeWind/places/RasterGround.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Readers and writers for the sections of a .treewind document.
namespace osgTreeWind {

/// A document while it is read.
struct ForestReading {
    ReadLog log;
    ForestFile forest;
    InputFolders folders;
    DocumentSpecies species{forest.species, log};
    DocumentTrees trees{forest.trees};
    TreeDefaults defaults;
    SceneMap map{forest};
};

/// Reads a whole document. Problems are in the log, sorted by position.
void readDocument(std::istream& input, const ForestFileOptions& options, ForestReading& reading);
/// Opens and reads a file.
void readDocumentFile(const std::string& path, std::size_t maxTrees, const std::vector<std::string>& settings,
                      ForestReading& reading);

void readRoot(TableReader& root, ForestReading& reading);

void readVersion(TableReader& root);
/// One [[species]], or [[group]].
void readSpecies(TableReader& table, const InputFolders& folders, DocumentSpecies& known);
/// One [[tree]].
void readTree(TableReader& table, const TreeDefaults& defaults, DocumentSpecies& species,
              DocumentTrees& trees);
/// One [[scatter]].
void readScatter(TableReader& table, const TreeDefaults& defaults, const SceneMap& map,
                 DocumentSpecies& species, DocumentTrees& trees);
/// One [[inventory]]. @param findGround opens [ground] on the map; null if there is none, or a problem that
/// is reported later.
void readInventory(TableReader& table, const InputFolders& folders, const TreeDefaults& defaults,
                   SceneMap& map, DocumentSpecies& species, DocumentTrees& trees,
                   const std::function<GroundPtr()>& findGround);
/// [tiles]. Empty after a problem.
std::optional<ForestTiles> readTiles(TableReader& table, const InputFolders& folders,
                                     const DocumentSpecies& species);
/// The keys of [ground]. Empty after a problem, or without files.
std::optional<RasterGround::Source> readGroundSource(TableReader& table, const InputFolders& folders);
/// Notes that the z of the places of inventories is taken as the height of feet, if there is no ground.
void noteFeetWithoutGround(TableReader& table, DocumentTrees& trees);
/// [ground], and puts the trees on it.
void readGround(TableReader& table, const InputFolders& folders, ForestDescription& forest, SceneMap& map,
                DocumentTrees& trees);
/// [wind]. @param forest must have its origin. @param seed of gusts.
Wind readWind(TableReader& table, const InputFolders& folders, const ForestDescription& forest,
              const SceneMap& map, DocumentTrees& trees, std::uint32_t seed);
/// The canopy of [wind]. Without it, decides whether the trees change the wind, and adds a note.
/// @param forest must have its wind and growing spaces.
void readCanopy(TableReader& table, ForestDescription& forest, DocumentTrees& trees);

/// Words of the key `wind.frame`.
const std::vector<std::pair<std::string, WindFrame>>& windFrames();

/// Why a document cannot refer to a file; empty if it can.
std::string problemOfFile(const std::string& file);
/// Writes [ground], if there is one. @return why it cannot be written; empty on success.
std::string writeGround(std::ostream& output, const ForestDescription& forest);
void writeTiles(std::ostream& output, const ForestTiles& tiles); ///< [tiles].
/// Writes [wind], if there is one. @return why it cannot be written; empty on success.
std::string writeWind(std::ostream& output, const ForestDescription& forest);

/// A message if the shapes of the forest have too many vertices; otherwise empty.
/// @param largest countLargest() of the families.
std::string problemOfShapes(const ShapeFamilies& families, const std::vector<TreeCounts>& largest);

} // namespace osgTreeWind
