// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/forest/GroundPlacer.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/StretchedMap.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/places/RasterGround.h>

#include <filesystem>

namespace osgTreeWind {

namespace {

/// The paths of `file`, which is one name or an array of tiles. Empty after a problem.
std::vector<std::string> findFiles(TableReader& table, ForestReading& reading) {
    std::vector<std::string> names(1), paths;
    if (table.hasArray("file") ? !table.read("file", names) : !table.require("file", names.front()))
        return {};
    if (names.empty())
        table.problem("file", "expected at least one file");
    for (const std::string& name : names)
        if (const auto file = reading.open(table, "file", name))
            paths.push_back(file->path);
    return paths.size() == names.size() ? paths : std::vector<std::string>();
}

void putTreesOnGround(TableReader& table, ForestReading& reading) {
    ForestDescription forest;
    forest.species = reading.forest.species;
    forest.ground = reading.forest.ground;
    forest.tiles = reading.forest.tiles ? *reading.forest.tiles : ForestTiles();
    reading.treeBounds().addSpeciesNames(forest.species, *forest.tiles);
    GroundPlacer placer(forest);
    reading.trees.modify([&](TreeSpool::Trees& trees, const std::vector<std::size_t>& onGround) {
        placer.place(trees, onGround);
    });
    for (const Diagnostic& problem : placer.problems())
        table.problem("file", problem.message);
}

} // namespace

void readGround(TableReader& table, ForestReading& reading) {
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
    source.files = findFiles(table, reading);
    if (source.files.empty())
        return;
    auto ground = RasterGround::open(source, reading.crs);
    if (ground && ground.value()->map() && !reading.crs) {
        reading.setCrs(*ground.value()->map());
        reprojectStretchedMap(reading);
        if (!reading.toScene.isIdentity())
            ground = RasterGround::open(source, reading.crs);
    }
    if (!ground) {
        const Diagnostic& problem = ground.problems().front();
        return problem.file.empty() ? table.problem(problem.key, problem.message) : reading.log.add(problem);
    }
    reading.forest.ground = ground.value();
    if (reading.log.problems.empty())
        putTreesOnGround(table, reading);
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
