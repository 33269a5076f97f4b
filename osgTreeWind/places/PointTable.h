// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace osgTreeWind {

/// Points with attributes: one layer of vector features.
struct PointTable {
    struct Row {
        glm::dvec3 position{0.0};
        std::vector<std::string> texts;
        std::vector<std::optional<double>> numbers;

        auto parts() { return std::tie(position, texts, numbers); } ///< For Wire.
    };

    std::string name;                        ///< Name of the layer.
    std::string crs;                         ///< Input for Crs::parse(); empty if unknown.
    std::vector<std::string> texts, numbers; ///< Names of the text and number columns.
    std::vector<Row> rows;                   ///< Each with a value per column.

    auto parts() { return std::tie(name, crs, texts, numbers, rows); } ///< For Wire.
};

/// Writes a new GeoPackage. @param path must not exist yet.
Diagnostics writeGeoPackage(PointTable table, const std::string& path);

} // namespace osgTreeWind
