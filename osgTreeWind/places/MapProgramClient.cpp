// SPDX-License-Identifier: MIT
// Functions that need GDAL or PROJ, implemented by requests to osgtreewind-map. That program and
// osgtreewind-weather link files of plugins/map instead.
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/places/CrsTransform.h>
#include <osgTreeWind/places/MapProgram.h>

#include <limits>
#include <utility>

namespace osgTreeWind {

using Task = MapRequest::Task;

Result<Crs> Crs::parse(const std::string& text) {
    Result<Facts> facts = MapProgram::shared()->request<Facts>({Task::ParseCrs, {text}});
    return facts ? Result<Crs>(Crs(facts.value())) : facts.problems();
}

bool Crs::isSame(const Crs& other) const {
    if (text() == other.text())
        return true;
    const auto same = MapProgram::shared()->request<bool>({Task::CompareCrs, {text(), other.text()}});
    return same && same.value();
}

Result<CrsTransform> CrsTransform::between(const Crs& from, const Crs& to) {
    CrsTransform transform;
    if (from.text() == to.text())
        return transform;
    const auto program = MapProgram::shared();
    const auto isNeeded = program->request<bool>({Task::FindTransform, {from.text(), to.text()}});
    if (!isNeeded)
        return isNeeded.problems();
    if (isNeeded.value()) {
        transform._from = from;
        transform._to = to;
        transform._handle = program;
    }
    return transform;
}

void CrsTransform::apply(std::vector<glm::dvec2>& places) const {
    if (isIdentity())
        return;
    auto there = static_cast<MapProgram*>(handle())->request<std::vector<glm::dvec2>>(
        {Task::TransformPoints, {_from.text(), _to.text()}, places});
    if (there && there.value().size() == places.size())
        places = std::move(there.value());
    else
        places.assign(places.size(), glm::dvec2(std::numeric_limits<double>::quiet_NaN()));
}

Result<GridMapping> gridMappingOf(const Crs& map) {
    return MapProgram::shared()->request<GridMapping>({Task::DescribeGridMapping, {map.text()}});
}

Result<RasterBand> readGeoTiffBand(const std::string& path) {
    if (const auto problem = problemOfInput(path))
        return *problem;
    return MapProgram({path}).request<RasterBand>({Task::ReadBand, {path}});
}

Diagnostics writeGeoPackage(PointTable table, const std::string& path) {
    return MapProgram({path}).request<MapAcknowledgement>({Task::WriteTable, {path}}, table).problems();
}

} // namespace osgTreeWind
