// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace osgTreeWind {

/// Points and what is known of each: a layer of a map.
struct PointTable {
    struct Row {
        glm::dvec3 position{0.0};
        std::vector<std::string> texts;
        std::vector<std::optional<double>> numbers;

        auto parts() { return std::tie(position, texts, numbers); } ///< For Wire.
    };

    std::string name;                        ///< Of the layer.
    std::string crs;                         ///< As Crs::parse() reads; empty: not known.
    std::vector<std::string> texts, numbers; ///< Names of the columns.
    std::vector<Row> rows;                   ///< Each with as many of both.

    auto parts() { return std::tie(name, crs, texts, numbers, rows); } ///< For Wire.
};

/// Writes it as a GeoPackage, where nothing is yet. @return what is wrong; empty: nothing.
Diagnostics writeGeoPackage(PointTable table, const std::string& path);

} // namespace osgTreeWind
