// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/GribBytes.h>
#include <plugins/weather/GribField.h>

#include <optional>

/// Sections of GRIB, one at a time.
namespace osgTreeWind::GribEditions {

/// Part of a field, or what is wrong with its section.
using Problem = std::optional<std::string>;

/// Of the flags of a grid: components of winds are along its axes.
constexpr int toGridFlag = 0x08;

/// Section 1 of edition 1: parameter, level and times.
Problem readProduct1(const GribBytes& section, GribField& field);
/// Section 2 of edition 1: the grid.
Problem readGrid1(const GribBytes& section, GribField& field);
/// Section 4 of edition 1: how numbers are packed.
void readPacking1(const GribBytes& section, GribField& field);

/// Section 1 of edition 2: centre and reference time.
Problem readOrigin2(const GribBytes& section, GribField& field);
/// Section 3 of edition 2: the grid.
Problem readGrid2(const GribBytes& section, GribField& field);
/// Section 4 of edition 2: parameter, level and time, after readOrigin2().
Problem readProduct2(const GribBytes& section, GribField& field);
/// Section 5 of edition 2: how numbers are packed.
void readPacking2(const GribBytes& section, GribField& field);

} // namespace osgTreeWind::GribEditions
