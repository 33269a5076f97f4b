// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/CompanyOfTrees.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/io/TableReader.h>
#include <osgTreeWind/io/TreeStore.h>
#include <osgTreeWind/io/TreesInAll.h>
#include <osgTreeWind/places/CrsWay.h>

#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// The sections of a .treewind document, one reader each. Not part of the interface.
namespace osgTreeWind {

/// What the sections share while a document is read.
struct ForestReading {
    ReadLog log;
    std::vector<std::string> folders; ///< Where relative paths are looked for, in order.
    std::size_t mostTrees = 1000000;  ///< More are a problem.
    std::uint32_t seed = 1;
    float leaves = 1.0f; ///< Of trees that do not say.
    ForestDescription forest;
    TreeStore trees{forest.trees};
    std::vector<UnsaidOfTree> unsaid; ///< By tree.
    std::optional<Crs> crs;           ///< That of the forest.
    bool keepsMap = false;            ///< `stretched`: whatever a metre of the map is on the ground.
    CrsWay toScene;                   ///< From the map of the file's places to `crs`, once that is known.
    std::optional<double> windDate;   ///< Seconds since 1970 of the wind's time 0, where its files say.
    bool saysSpecies = false;         ///< Whether the file has [[species]].
    std::size_t declaredSpecies = 0;  ///< Number of the file's own species. Built-in ones follow them.
    std::map<std::string, std::size_t> speciesByName; ///< Folded names and aliases to indices.
    std::set<std::string> treeNames;                  ///< Of all trees so far.
    const SpeciesCatalogue* catalogue = nullptr;      ///< Null until it is asked for.

    /// Index of the species with this name or alias, whatever its case.
    std::optional<std::size_t> species(const std::string& name) const;
    /// The same, or else a built-in species of that name, which then is one of the forest's; if the document
    /// has a species of its own by the built-in one's common name, that one.
    std::optional<std::size_t> speciesOrBuiltIn(const std::string& name);
    /// The index of a built-in species, which then is one of the forest's, as above. @param found null: none.
    std::optional<std::size_t> takeBuiltIn(const Species* found);
    /// Where species are looked for that the document has not. If that of the host is broken, its problems
    /// are now those of the reading.
    const SpeciesCatalogue& builtIn();
    TreesInAll treesInAll();
    /// The next tree. @param onGround as TreeStore::add().
    void addTree(const TreePlacement& tree, bool onGround, UnsaidOfTree said);
    /// Takes the crs that an inventory or the ground asks for.
    void choose(const Crs& chosen);
    /// A place of the file in the scene's map.
    glm::dvec3 inScene(const glm::dvec3& place) const;
    /// Whether `count` more trees are still allowed; a problem with `key` when not.
    bool roomFor(std::uint64_t count, TableReader& table, const std::string& key);

    /// Those of the file, of its host and of OSG: what OSGTREEWIND_TRUST=folder trusts.
    std::vector<std::string> trustedFolders() const;

    struct InputFile {
        std::string path;
        std::ifstream stream;
    };
    /// Opens the file that `key` names; a problem when it cannot.
    std::optional<InputFile> open(TableReader& table, const std::string& key);
    /// The same for the file called `name`, which `key` names among others.
    std::optional<InputFile> open(TableReader& table, const std::string& key, const std::string& name);
};

/// The whole document; problems are those of the reading's log, in order of place.
void readDocument(std::istream& input, const ForestFileOptions& options, ForestReading& reading);
/// The same of a file, and what keeps it from being opened.
void readDocumentFile(const std::string& path, std::size_t mostTrees,
                      const std::vector<std::string>& settings, ForestReading& reading);

void readRoot(TableReader& root, ForestReading& reading);

void readVersion(TableReader& root);                            ///< Of any document.
void readSpecies(TableReader& table, ForestReading& reading);   ///< One [[species]], or [[group]].
void readTree(TableReader& table, ForestReading& reading);      ///< One [[tree]].
void readScatter(TableReader& table, ForestReading& reading);   ///< One [[scatter]].
void readInventory(TableReader& table, ForestReading& reading); ///< One [[inventory]].
void readTiles(TableReader& table, ForestReading& reading);     ///< [tiles].
void readGround(TableReader& table, ForestReading& reading);    ///< [ground], and puts the trees on it.
void readWind(TableReader& table, ForestReading& reading);      ///< [wind]; needs the forest's origin.

/// `wind.frame`.
const std::vector<std::pair<std::string, WindFrame>>& windFrames();

/// [ground], if there is one. @return what keeps it from being written; empty when all is well.
std::string writeGround(std::ostream& output, const ForestDescription& forest);
void writeTiles(std::ostream& output, const ForestTiles& tiles); ///< [tiles].
/// [wind], if there is one. @return what keeps it from being written; empty when all is well.
std::string writeWind(std::ostream& output, const ForestDescription& forest);

/// That its distinct shapes have too many vertices; empty when they have not.
std::string problemOfShapes(const ForestDescription& forest);

} // namespace osgTreeWind
