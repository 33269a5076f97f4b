// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/forest/FeetOnGround.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/StretchedMap.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/places/RasterGround.h>

#include <filesystem>

namespace osgTreeWind {

namespace {

/// The files of `file`: one, or an array of tiles. Empty, and problems, where there is none.
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
    reading.treesInAll().nameCompanies(forest.species, *forest.tiles);
    FeetOnGround feet(forest);
    reading.trees.change([&](TreeStore::Trees& trees, const std::vector<std::size_t>& onGround) {
        feet.put(trees, onGround);
    });
    for (const Diagnostic& problem : feet.problems())
        table.problem("file", problem.message);
}

} // namespace

void readGround(TableReader& table, ForestReading& reading) {
    bool none = false;
    const bool isRead = table.read("none", none);
    const bool isBeside = none && (table.has("file") || table.has("crs"));
    if (isBeside)
        table.problem("none", "expected neither file nor crs beside it");
    if (isBeside || (table.has("none") && !isRead))
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
        reading.choose(*ground.value()->map());
        leaveStretchedMap(reading);
        if (!reading.toScene.staysHere())
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
        return "a ground that no file can say: expected one from files, not a callable";
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
