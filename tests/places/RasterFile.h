// SPDX-License-Identifier: MIT
#pragma once

#include <gdal.h>
#include <gtest/gtest.h>
#include <ogr_srs_api.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// A raster written with GDAL for a test. By default it has 4 x 4 cells of 1 m in [0, 4].
struct RasterFile {
    int columns = 4, rows = 4;
    std::function<double(int column, int row)> value = [](int column, int row) {
        return 100.0 + column + 10.0 * row;
    };
    std::array<double, 6> transform{0, 1, 0, 4, 0, -1};
    std::string crs{};
    GDALDataType type = GDT_Float32;
    std::optional<double> nodata{};
    double scale = 1.0, offset = 0.0;
    std::string unit{};
    int bands = 1;
    double bandStep = 0.0;            ///< Added to the value for each further band.
    std::vector<std::string> names{}; ///< Of the bands; may be fewer.
    bool isPalette = false;

    /// @param tiles write a GeoTIFF in compressed tiles of 256 x 256. @return the path.
    std::string write(const std::string& path, const char* format = "GTiff", bool tiles = false) const {
        GDALAllRegister();
        const char* const tiled[] = {"TILED=YES", "COMPRESS=DEFLATE", nullptr};
        const GDALDatasetH data = GDALCreate(GDALGetDriverByName(format), path.c_str(), columns, rows, bands,
                                             type, const_cast<char**>(tiles ? tiled : nullptr));
        EXPECT_TRUE(data) << path;
        GDALSetGeoTransform(data, const_cast<double*>(transform.data()));
        if (!crs.empty()) {
            const OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
            EXPECT_EQ(OSRSetFromUserInput(reference, crs.c_str()), OGRERR_NONE);
            GDALSetSpatialRef(data, reference);
            OSRRelease(reference);
        }
        for (int i = 1; i <= bands; ++i)
            writeBand(GDALGetRasterBand(data, i), static_cast<std::size_t>(i - 1));
        GDALClose(data);
        return path;
    }

private:
    void writeBand(GDALRasterBandH band, std::size_t index) const {
        if (index < names.size())
            GDALSetDescription(band, names[index].c_str());
        if (nodata)
            GDALSetRasterNoDataValue(band, *nodata);
        GDALSetRasterScale(band, scale);
        GDALSetRasterOffset(band, offset);
        if (!unit.empty())
            GDALSetRasterUnitType(band, unit.c_str());
        if (isPalette) {
            const GDALColorTableH colours = GDALCreateColorTable(GPI_RGB);
            const GDALColorEntry red{255, 0, 0, 255};
            GDALSetColorEntry(colours, 7, &red);
            GDALSetRasterColorTable(band, colours);
            GDALDestroyColorTable(colours);
        }
        std::vector<double> line(static_cast<std::size_t>(columns));
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column)
                line[static_cast<std::size_t>(column)] =
                    value(column, row) + static_cast<double>(index) * bandStep;
            EXPECT_EQ(
                GDALRasterIO(band, GF_Write, 0, row, columns, 1, line.data(), columns, 1, GDT_Float64, 0, 0),
                CE_None);
        }
    }
};
