// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/InventoryColumns.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/io/TableReader.h>
#include <osgTreeWind/places/UnitSize.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <map>

namespace osgTreeWind {

namespace {

// Metres, from the largest trees measured: coast redwood Hyperion; a live oak's mean spread of 47 m, with a
// margin; and the trunk of General Sherman.
constexpr double maxHeight = 116.0, maxCrownWidth = 60.0, maxTrunkDiameter = 7.8;

/// The name of a column in a format, and the key that it corresponds to.
struct KnownColumn {
    const char *format, *key, *name;
};
const KnownColumn knownColumns[] = {
    {"CityJSON", "id", "id"},
    {"CityJSON", "species", "species"},
    {"CityJSON", "height", "height"},
    {"CityJSON", "trunk_diameter", "trunkDiameter"},
    {"CityJSON", "crown_width", "crownDiameter"},
    {"OSM", "id", "osm_id"},
    {"OSM", "id", "@id"},
    {"OSM", "species", "species"},
    {"OSM", "species", "taxon"},
    {"OSM", "species", "genus"},
    {"OSM", "leaf_type", "leaf_type"},
    {"OSM", "height", "height"},
    {"OSM", "circumference", "circumference"},
    {"OSM", "crown_width", "diameter_crown"},
};

/// The first column with a name that open-data portals and databases use for places.
std::optional<std::size_t> findPointColumn(const TreeRows& rows) {
    for (const char* const name : {"geo_point_2d", "geopoint", "geo_point", "geom", "the_geom",
                                   "wkb_geometry", "geometry", "geo_shape", "wkt", "wkt_geom", "geojson",
                                   "shape", "point", "location", "coordinates", "latlon", "latlng"})
        for (std::size_t i = 0; i < rows.columns().size(); ++i)
            if (lower(rows.columns()[i]) == name)
                return i;
    return std::nullopt;
}

} // namespace

InventoryColumns::InventoryColumns()
    : height{"height", above(0, maxHeight)}, trunkDiameter{"trunk_diameter", above(0, maxTrunkDiameter)},
      circumference{"circumference", above(0, glm::pi<double>() * maxTrunkDiameter)},
      crownWidth{"crown_width", above(0, maxCrownWidth)} {
    trunkDiameter.kind = circumference.kind = SizeKind::Trunk;
    crownWidth.kind = SizeKind::Width;
}

void InventoryColumns::read(TableReader& table, TreeRows* rows) {
    table.table("columns", [&](TableReader& columns) {
        for (MeasureColumn* measure : measures())
            measure->column = find(columns, measure->key, rows);
        id = find(columns, "id", rows);
        if (const auto column = find(columns, "species", rows))
            species = {*column};
        point = find(columns, "point", rows);
        if (x.column && x.column == y.column)
            std::swap(point, x.column);
        if (rows && !point && !columns.has("point") && !columns.has("x") && !columns.has("y") &&
            !rows->hasPlaces())
            point = findPointColumn(*rows);
        if (rows && columns.has("x") != columns.has("y"))
            _complete = columns.reportMissing(columns.has("x") ? "y" : "x");
        else if (rows && !hasPlaceColumns() && !columns.has("x") && !columns.has("point") &&
                 !rows->hasPlaces())
            _complete = columns.reportMissing("x");
    });
    if (!table.has("columns") && rows && !rows->hasPlaces()) {
        table.problem("columns", "missing; the file has " + joined(rows->columns()));
        _complete = false;
    }
    readUnits(table, rows);
    if (rows)
        useKnownColumns(*rows);
    if (rows && !table.has("columns") && !id && species.empty() && !rows->columns().empty())
        table.note(rows->file() + ": only places are read without inventory.columns; the file has " +
                   joined(rows->columns()));
}

std::optional<std::size_t> InventoryColumns::find(TableReader& columns, const std::string& key,
                                                  TreeRows* rows) {
    std::string name;
    if (std::vector<std::string> several; columns.hasArray(key) && columns.read(key, several))
        columns.problem(key, "expected one column, or an expression such as \"genus || ' ' || epithet\"");
    const bool isNamed = !columns.hasArray(key) && columns.read(key, name) && rows;
    std::optional<std::size_t> column;
    if (isNamed) {
        if (const Result<std::size_t> found = rows->columnOrExpression(name))
            column = found.value();
        else
            columns.problem(key, found.problems().front().message);
    }
    _complete = _complete && (column || !columns.has(key));
    return column;
}

void InventoryColumns::useKnownColumns(const TreeRows& rows) {
    const bool isSpeciesGiven = !species.empty();
    for (const KnownColumn& known : knownColumns) {
        const auto column = rows.format() == known.format ? rows.column(known.name) : std::nullopt;
        if (!column)
            continue;
        if (known.key == std::string("species")) {
            if (!isSpeciesGiven)
                species.push_back(*column);
        } else if (known.key == std::string("leaf_type")) {
            leafType = column;
        } else if (known.key == std::string("id")) {
            id = id ? id : column;
        } else
            for (MeasureColumn* measure : measures())
                if (measure->key == std::string(known.key) && !measure->column)
                    measure->column = column;
    }
}

/// Reads the units that keys or columns give. A CRS gives those of x and y.
void InventoryColumns::readUnits(TableReader& table, const TreeRows* rows) {
    std::map<const MeasureColumn*, double> asked;
    table.table("units", [&](TableReader& units) {
        for (MeasureColumn* measure : measures())
            if (const auto size = units.readUnit(measure->key, Dimension::Length))
                asked[measure] = measure->unit = *size;
    });
    std::vector<std::string> used, replaced, unknown;
    for (MeasureColumn* measure : measures()) {
        const bool hasCrs = (measure == &x || measure == &y) && rows &&
                            (table.has("crs") || rows->crs() || areInDegrees(*rows));
        if (!rows || !measure->column || *measure->column >= rows->columns().size() || hasCrs)
            continue;
        const std::string& name = rows->nameOf(*measure->column);
        const std::string unit = rows->unitOf(Dimension::Length, *measure->column);
        if (unit.empty())
            continue;
        const Result<double> size = sizeOfUnit(Dimension::Length, unit);
        if (!asked.count(measure) && size)
            measure->unit = size.value();
        if (!size && !asked.count(measure))
            unknown.push_back(inQuotes(name));
        else if (size && size.value() != measure->unit)
            replaced.push_back(inQuotes(name));
        else if (size && size.value() != 1.0 && !asked.count(measure))
            used.push_back(inQuotes(name));
    }
    const auto note = [&](const char* text, const std::vector<std::string>& names) {
        if (!names.empty())
            table.note(rows->file() + ": " + text + joined(names));
    };
    note("columns give their units, unless inventory.units does: ", used);
    note("inventory.units replaces the units of columns: ", replaced);
    note("columns give no known unit, and metres are assumed, unless inventory.units sets "
         "another: ",
         unknown);
}

std::vector<std::size_t> InventoryColumns::allColumns() {
    std::vector<std::size_t> columns = species;
    for (const MeasureColumn* measure : measures())
        if (measure->column)
            columns.push_back(*measure->column);
    for (const auto& column : {id, point, leafType})
        if (column)
            columns.push_back(*column);
    return columns;
}

bool InventoryColumns::areInDegrees(const TreeRows& rows) const {
    const auto isCalled = [&](const MeasureColumn& measure, const std::vector<std::string>& names) {
        return measure.column && std::count(names.begin(), names.end(), lower(rows.nameOf(*measure.column)));
    };
    return isCalled(x, {"longitude", "lon", "long", "lng"}) && isCalled(y, {"latitude", "lat"});
}

} // namespace osgTreeWind
