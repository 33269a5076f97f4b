// SPDX-License-Identifier: MIT
#include <plugins/map/GdalCrs.h>
#include <plugins/map/GdalErrors.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/places/PointTable.h>

#include <gdal.h>
#include <ogr_api.h>

#include <memory>

namespace osgTreeWind {

namespace {

bool addColumns(OGRLayerH layer, const std::vector<std::string>& names, OGRFieldType type) {
    bool added = true;
    for (const std::string& name : names) {
        const OGRFieldDefnH column = OGR_Fld_Create(name.c_str(), type);
        added &= OGR_L_CreateField(layer, column, true) == OGRERR_NONE;
        OGR_Fld_Destroy(column);
    }
    return added;
}

bool add(OGRLayerH layer, const PointTable::Row& row) {
    const std::unique_ptr<void, decltype(&OGR_F_Destroy)> feature(OGR_F_Create(OGR_L_GetLayerDefn(layer)),
                                                                  &OGR_F_Destroy);
    int column = 0;
    for (const std::string& text : row.texts)
        OGR_F_SetFieldString(feature.get(), column++, text.c_str());
    for (const std::optional<double>& number : row.numbers) {
        if (number)
            OGR_F_SetFieldDouble(feature.get(), column, *number);
        ++column;
    }
    const OGRGeometryH point = OGR_G_CreateGeometry(wkbPoint25D);
    OGR_G_SetPoint(point, 0, row.position.x, row.position.y, row.position.z);
    OGR_F_SetGeometryDirectly(feature.get(), point);
    return OGR_L_CreateFeature(layer, feature.get()) == OGRERR_NONE;
}

bool write(const PointTable& table, const GdalCrs& crs, const std::string& path) {
    const std::unique_ptr<void, void (*)(void*)> data(
        GDALCreate(GDALGetDriverByName("GPKG"), path.c_str(), 0, 0, 0, GDT_Unknown, nullptr), [](void* made) {
            if (made)
                GDALClose(made);
        });
    const OGRLayerH layer =
        data ? GDALDatasetCreateLayer(data.get(), table.name.c_str(), crs.reference(), wkbPoint25D, nullptr)
             : nullptr;
    if (!layer || !addColumns(layer, table.texts, OFTString) || !addColumns(layer, table.numbers, OFTReal) ||
        GDALDatasetStartTransaction(data.get(), false) != OGRERR_NONE)
        return false;
    for (const PointTable::Row& row : table.rows)
        if (!add(layer, row))
            return false;
    return GDALDatasetCommitTransaction(data.get()) == OGRERR_NONE;
}

} // namespace

Diagnostics writeGeoPackage(PointTable table, const std::string& path) {
    registerGdal();
    GdalCrs crs;
    if (!table.crs.empty()) {
        const Result<GdalCrs> known = GdalCrs::parse(table.crs);
        if (!known)
            return known.problems();
        crs = known.value();
    }
    const GdalErrors errors;
    const bool written = write(table, crs, path);
    if (!written || !errors.text().empty())
        return {fileProblem(path, "cannot be written: " + errors.textOr("GDAL gives no reason"))};
    return {};
}

} // namespace osgTreeWind
