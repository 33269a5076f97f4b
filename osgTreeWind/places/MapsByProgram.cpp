// SPDX-License-Identifier: MIT
// What GDAL and PROJ have to do, as the library has it: it asks osgtreewind-map. In that program and in
// osgtreewind-weather files of plugins/map stand in place of this.
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/places/CrsWay.h>
#include <osgTreeWind/places/MapProgram.h>

#include <limits>
#include <utility>

namespace osgTreeWind {

using Task = MapQuestion::Task;

Result<Crs> Crs::parse(const std::string& text) {
    Result<Facts> facts = MapProgram::shared()->ask<Facts>({Task::ParseCrs, {text}});
    return facts ? Result<Crs>(Crs(facts.value())) : facts.problems();
}

bool Crs::isSame(const Crs& other) const {
    if (text() == other.text())
        return true;
    const auto same = MapProgram::shared()->ask<bool>({Task::CompareCrs, {text(), other.text()}});
    return same && same.value();
}

Result<CrsWay> CrsWay::between(const Crs& from, const Crs& to) {
    CrsWay way;
    if (from.text() == to.text())
        return way;
    const auto program = MapProgram::shared();
    const auto isOne = program->ask<bool>({Task::FindWay, {from.text(), to.text()}});
    if (!isOne)
        return isOne.problems();
    if (isOne.value()) {
        way._from = from;
        way._to = to;
        way._held = program;
    }
    return way;
}

void CrsWay::go(std::vector<glm::dvec2>& places) const {
    if (staysHere())
        return;
    auto there = static_cast<MapProgram*>(transformation())
                     ->ask<std::vector<glm::dvec2>>({Task::BringPlaces, {_from.text(), _to.text()}, places});
    if (there && there.value().size() == places.size())
        places = std::move(there.value());
    else
        places.assign(places.size(), glm::dvec2(std::numeric_limits<double>::quiet_NaN()));
}

Result<GridMapping> gridMappingOf(const Crs& map) {
    return MapProgram::shared()->ask<GridMapping>({Task::DescribeMap, {map.text()}});
}

Result<MapCells> readGeoTiffCells(const std::string& path) {
    if (const auto problem = problemOfInput(path))
        return *problem;
    return MapProgram({path}).ask<MapCells>({Task::ReadCells, {path}});
}

Diagnostics writeGeoPackage(PointTable table, const std::string& path) {
    return MapProgram({path}).ask<MapDone>({Task::WriteTable, {path}}, table).problems();
}

} // namespace osgTreeWind
