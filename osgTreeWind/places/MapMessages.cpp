// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/MapMessages.h>

namespace osgTreeWind {

bool passMembers(Wire& wire, MapQuestion& question) {
    return wire.pass(question.task, question.texts, question.places, question.columns);
}

bool passMembers(Wire& wire, Crs::Facts& facts) {
    return wire.pass(facts.text, facts.name, facts.problemOfMap, facts.isDegrees);
}

bool passMembers(Wire& wire, GridMapping& mapping) {
    return wire.pass(mapping.name, mapping.numbers, mapping.wkt);
}

bool passMembers(Wire& wire, GridMapping::Numbers& numbers) {
    return wire.pass(numbers.first, numbers.second);
}

bool passMembers(Wire& wire, MapCells& cells) {
    return wire.pass(cells.cells, cells.south, cells.cellSize, cells.values, cells.crs, cells.unit);
}

bool passMembers(Wire& wire, RasterHead& head) {
    return wire.pass(head.crs, head.columns, head.rows, head.toPlace, head.toCell);
}

bool passMembers(Wire& wire, FeatureFileHead& head) {
    return wire.pass(head.format, head.layers, head.warnings);
}

bool passMembers(Wire& wire, FeatureLayer& layer) {
    return wire.pass(layer.where, layer.columns, layer.crs, layer.hasGeometry);
}

bool passMembers(Wire& wire, FeatureBatch& batch) {
    return wire.pass(batch.ids, batch.places, batch.placeless, batch.columns, batch.problem, batch.isLast);
}

bool passMembers(Wire& wire, FeatureBatch::Column& column) {
    return wire.pass(column.kinds, column.numbers, column.texts, column.ends);
}

bool passMembers(Wire& wire, FeatureBatch::Placeless& placeless) {
    return wire.pass(placeless.index, placeless.message);
}

bool passMembers(Wire& wire, PointTable& table) {
    return wire.pass(table.name, table.crs, table.texts, table.numbers, table.rows);
}

bool passMembers(Wire& wire, PointTable::Row& row) {
    return wire.pass(row.position, row.texts, row.numbers);
}

} // namespace osgTreeWind
