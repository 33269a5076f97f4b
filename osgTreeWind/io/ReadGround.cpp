// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/forest/GroundPlacer.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/places/RasterGround.h>

#include <filesystem>

namespace osgTreeWind {

namespace {

/// The paths of `file`, which is one name or an array of tiles. Empty after a problem.
std::vector<std::string> findFiles(TableReader& table, const InputFolders& folders) {
    std::vector<std::string> names(1), paths;
    if (table.hasArray("file") ? !table.read("file", names) : !table.require("file", names.front()))
        return {};
    if (names.empty())
        table.problem("file", "expected at least one file");
    for (const std::string& name : names)
        if (const auto file = folders.open(table, "file", name))
            paths.push_back(file->path);
    return paths.size() == names.size() ? paths : std::vector<std::string>();
}

void putTreesOnGround(TableReader& table, const ForestDescription& read, DocumentTrees& trees) {
    ForestDescription forest;
    forest.species = read.species;
    forest.ground = read.ground;
    forest.tiles = read.tiles ? *read.tiles : ForestTiles();
    trees.bounds().addSpeciesNames(forest.species, *forest.tiles);
    GroundPlacer placer(forest);
    trees.modify([&](TreeSpool::Trees& some, const std::vector<std::size_t>& onGround) {
        placer.place(some, onGround);
    });
    const std::string advice = trees.adviceToExchange(
        [&](const glm::dvec2& place) { return heightOf(*read.ground, place).has_value(); });
    Diagnostics problems = placer.problems();
    if (problems.empty() && !advice.empty())
        problems = {keyProblem("file", "no ground below the trees of an inventory")};
    for (const Diagnostic& problem : problems)
        table.problem("file", problem.message + advice);
}

} // namespace

void readGround(TableReader& table, const InputFolders& folders, ForestDescription& forest, SceneMap& map,
                DocumentTrees& trees) {
    bool none = false;
    const bool isRead = table.read("none", none);
    const bool isConflict = none && (table.has("file") || table.has("crs"));
    if (isConflict)
        table.problem("none", "cannot be combined with file or crs");
    if (isConflict || (table.has("none") && !isRead))
        return table.ignoreRest();
    if (none)
        return;
    RasterGround::Source source;
    table.read("crs", source.crs);
    if (int number = 0; !table.readScalar("band", source.band) && table.has("band"))
        if (table.read("band", number, within(1, 65535)))
            source.band = std::to_string(number);
    source.files = findFiles(table, folders);
    if (source.files.empty())
        return;
    auto ground = RasterGround::open(source, map.crs());
    if (ground && ground.value()->map() && !map.crs()) {
        map.set(*ground.value()->map());
        map.reproject(trees, table);
        if (map.isReprojected())
            ground = RasterGround::open(source, map.crs());
    }
    if (!ground) {
        const Diagnostic& problem = ground.problems().front();
        return problem.file.empty() ? table.problem(problem.key, problem.message) : table.report(problem);
    }
    forest.ground = ground.value();
    if (table.isDocumentValid())
        putTreesOnGround(table, forest, trees);
}

std::string writeGround(std::ostream& output, const ForestDescription& forest) {
    if (!forest.ground)
        return {};
    const auto rasters = dynamic_cast<const RasterGround*>(forest.ground.get());
    if (!rasters)
        return "this ground cannot be written to a file: expected one from files, not a callable";
    std::vector<std::string> files;
    for (const std::string& file : rasters->source().files) {
        if (std::string problem = problemOfFile(file); !problem.empty())
            return problem;
        files.push_back(std::filesystem::absolute(file).string());
    }
    output << "\n[ground]\nfile = " << tomlText(files) << '\n';
    if (const std::string& crs = rasters->source().crs; !crs.empty())
        output << "crs = " << tomlText(crs) << '\n';
    if (const std::string& band = rasters->source().band; !band.empty())
        output << "band = " << tomlText(band) << '\n';
    return {};
}

} // namespace osgTreeWind
