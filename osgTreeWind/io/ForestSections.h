// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/GrowingSpaces.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/io/TableReader.h>
#include <osgTreeWind/io/TreeBounds.h>
#include <osgTreeWind/io/TreeSpool.h>
#include <osgTreeWind/places/CrsTransform.h>

#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// Readers and writers for the sections of a .treewind document.
namespace osgTreeWind {

/// Folders in which OpenSceneGraph searches for files, from the environment variable OSG_FILE_PATH.
std::vector<std::string> hostFolders();

/// State shared by the section readers while a document is read.
struct ForestReading {
    ReadLog log;
    std::vector<std::string> folders; ///< Searched for relative paths, in order.
    std::size_t maxTrees = 1000000;   ///< More trees are an error.
    std::uint32_t seed = 1;
    float leaves = 1.0f; ///< Default share of leaves of a tree.
    ForestDescription forest;
    TreeSpool trees{forest.trees};
    std::vector<DerivedTreeValues> derived; ///< By tree.
    std::optional<Crs> crs;                 ///< CRS of the scene.
    bool keepsStretchedMap = false;         ///< Key `stretched`: do not leave a stretched map.
    CrsTransform toScene;                   ///< From the file's map to `crs`, once that is known.
    std::optional<double> windDate;         ///< Date of the wind's time 0, seconds since 1970, if known.
    bool hasSpeciesTables = false;          ///< The file has [[species]].
    std::size_t declaredSpecies = 0;        ///< Number of the file's species. Built-in ones follow them.
    std::map<std::string, std::size_t> speciesByName; ///< Folded names and aliases to indices.
    std::set<std::string> treeNames;                  ///< Names of all trees so far.
    const SpeciesCatalogue* catalogue = nullptr;      ///< Null until builtIn() is called.

    /// Index of the forest's species with this name or alias, ignoring case.
    std::optional<std::size_t> species(const std::string& name) const;
    /// Index of the forest's species with this name, or else of the built-in species, which is added to the
    /// forest if needed (addBuiltIn()).
    std::optional<std::size_t> speciesOrBuiltIn(const std::string& name);
    /// Adds a built-in species unless the forest has one of that name. @param found may be null.
    std::optional<std::size_t> addBuiltIn(const Species* found);
    /// The species catalogue. Problems with the host's catalogue file go to the log.
    const SpeciesCatalogue& builtIn();
    TreeBounds treeBounds();
    /// Appends a tree. @param onGround as in TreeSpool::add().
    void addTree(const TreePlacement& tree, bool onGround, DerivedTreeValues derivedValues);
    /// Sets the CRS that an inventory or the ground requires.
    void setCrs(const Crs& newCrs);
    /// Transforms a place of the file to the scene's CRS.
    glm::dvec3 scenePlace(const glm::dvec3& place) const;
    /// Whether `count` more trees are allowed; otherwise reports a problem with `key`.
    bool canAddTrees(std::uint64_t count, TableReader& table, const std::string& key);

    /// Folders that OSGTREEWIND_TRUST=folder trusts: those of the file, its host and OSG.
    std::vector<std::string> trustedFolders() const;

    struct InputFile {
        std::string path;
        std::ifstream stream;
    };
    /// Opens the file named by `key`; reports a problem if that fails.
    std::optional<InputFile> open(TableReader& table, const std::string& key);
    /// Opens the file `name`, one of several named by `key`.
    std::optional<InputFile> open(TableReader& table, const std::string& key, const std::string& name);
};

/// Reads a whole document. Problems are in the log, sorted by position.
void readDocument(std::istream& input, const ForestFileOptions& options, ForestReading& reading);
/// Opens and reads a file.
void readDocumentFile(const std::string& path, std::size_t maxTrees, const std::vector<std::string>& settings,
                      ForestReading& reading);

void readRoot(TableReader& root, ForestReading& reading);

void readVersion(TableReader& root);
void readSpecies(TableReader& table, ForestReading& reading);   ///< One [[species]], or [[group]].
void readTree(TableReader& table, ForestReading& reading);      ///< One [[tree]].
void readScatter(TableReader& table, ForestReading& reading);   ///< One [[scatter]].
void readInventory(TableReader& table, ForestReading& reading); ///< One [[inventory]].
void readTiles(TableReader& table, ForestReading& reading);     ///< [tiles].
void readGround(TableReader& table, ForestReading& reading);    ///< [ground], and puts the trees on it.
void readWind(TableReader& table, ForestReading& reading);      ///< [wind]; needs the forest's origin.

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
std::string problemOfShapes(const ForestDescription& forest);

} // namespace osgTreeWind
