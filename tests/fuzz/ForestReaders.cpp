// SPDX-License-Identifier: MIT
#include <tests/fuzz/Readers.h>

#include <osgTreeWind/base/SizeText.h>
#include <osgTreeWind/io/CrownSummary.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TileIds.h>
#include <osgTreeWind/io/TileTrees.h>
#include <osgTreeWind/io/Toml.h>
#include <osgTreeWind/io/TomlEdit.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/places/PlaceText.h>

#include <cmath>
#include <fstream>
#include <numeric>
#include <sstream>

namespace osgTreeWind {

namespace {

/// Requires that the result is an error with a message, or a forest that stays the same when written and
/// read.
void readDocument(const std::string& document) {
    ForestFileOptions options;
    options.file = "fuzz";
    options.maxTrees = 2000;
    std::istringstream input(document);
    const auto forest = readForest(input, options);
    std::ostringstream written, again;
    if (!isRead(forest) || !writeForest(forest.value(), written).empty())
        return;
    std::istringstream second(written.str());
    const auto read = readForest(second, options);
    require(read && writeForest(read.value(), again).empty() && again.str() == written.str());
}

void readInventory(const std::string& table) {
    std::ofstream(fuzzFile(), std::ios::binary) << table;
    readDocument("version = 1\n[[inventory]]\nfile = \"" + fuzzFile() +
                 "\"\nspecies = \"oak\"\n[inventory.columns]\nx = \"x\"\ny = \"y\"\nid = \"id\"\n"
                 "species = \"species\"\nheight = \"height\"\ntrunk_diameter = \"dbh\"\n"
                 "[inventory.units]\ntrunk_diameter = \"cm\"\n");
}

/// An expression as a condition and as a column.
void readExpression(const std::string& expression) {
    std::ofstream(fuzzFile()) << "id,x,y,species,height\n1,2,3,Quercus robur,20\n2,5,9,birch,\n03,5.5,-,,x\n";
    const std::string head = "version = 1\n[[inventory]]\nfile = \"" + fuzzFile() + "\"\nspecies = \"oak\"\n";
    const std::string columns = "[inventory.columns]\nx = \"x\"\ny = \"y\"\nid = \"id\"\n";
    readDocument(head + "filter = " + tomlText(expression) + '\n' + columns);
    readDocument(head + columns + "height = " + tomlText(expression) + '\n');
}

/// A cell as a place and as a size.
void readCell(const std::string& cell) {
    const PlaceText place = parsePlace(cell);
    require(std::isfinite(place.place.x) && std::isfinite(place.place.y) &&
            std::isfinite(place.z.value_or(0.0)));
    for (const SizeKind kind : {SizeKind::Height, SizeKind::Width, SizeKind::Trunk})
        if (const auto size = parseSize(cell, kind))
            require(std::isfinite(size->value));
}

/// Requires that an edit does not change other values of a document that stays valid.
void editDocument(const std::string& text) {
    const Result<toml::table> before = parseToml(text);
    if (!before)
        return;
    TomlEdit edit(text);
    edit.set("wind", "speed", "1.5");
    edit.remove("motion", "gain");
    const Result<toml::table> after = parseToml(edit.text());
    if (!after || after.value()["wind"]["speed"].value<double>() != 1.5)
        return;
    toml::table old = before.value(), now = after.value();
    for (toml::table* document : {&old, &now}) {
        if (toml::table* wind = (*document)["wind"].as_table())
            wind->erase("speed");
        if (toml::table* motion = (*document)["motion"].as_table())
            motion->erase("gain");
    }
    if (!old.contains("wind"))
        now.erase("wind");
    require(old != old || old == now); // NaN differs from itself
}

/// Writes a tile as text.
std::string tileText(const TileTrees& tile) {
    std::vector<Species> species(tile.species.size());
    for (std::size_t i = 0; i < species.size(); ++i)
        species[i].name = tile.species[i];
    std::vector<std::uint32_t> all(tile.trees.size());
    std::iota(all.begin(), all.end(), 0);
    return tileHeader() + tileRows(tile.trees, all, species);
}

/// The answer of a tile server is a tile, its ids or its crowns.
void readTile(const std::string& text) {
    std::istringstream ids(text), crowns(text), input(text);
    isRead(readTileIds(ids, "fuzz"));
    isRead(readCrownSummary(crowns, "fuzz"));
    auto tile = readTileTrees(input, "fuzz");
    if (!isRead(tile))
        return;
    const std::string rows = tileText(tile.value());
    std::istringstream again(rows);
    const auto read = readTileTrees(again, "again");
    require(read && tileText(read.value()) == rows);
    const std::vector<Species> known(1);
    static_cast<void>(tile.value().resolve(known, tile.value().trees.size(), "fuzz"));
}

const FuzzReaders forestReaders = {{"Forest", readDocument},          {"Inventory", readInventory},
                                   {"RowExpression", readExpression}, {"Cell", readCell},
                                   {"TomlEdit", editDocument},        {"Tile", readTile}};

} // namespace

} // namespace osgTreeWind
