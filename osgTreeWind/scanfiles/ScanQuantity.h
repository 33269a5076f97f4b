// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/model/ScannedTree.h>

#include <string>

/// Quantities of cylinders and their ranges, shared by the readers of scans. Not part of the interface.
namespace osgTreeWind {

/// A quantity of a cylinder: its description for messages, and its range.
struct ScanQuantity {
    const char* description;
    Range range;
};

constexpr ScanQuantity scanMetres{"metres within 1e9", within(-1e9, 1e9)};
constexpr ScanQuantity scanRadius{"a radius above 0 and of at most 10 m", within(1e-9, 10.0)};
constexpr ScanQuantity scanDiameter{"a diameter above 0 and of at most 20 m", within(2e-9, 20.0)};
constexpr ScanQuantity scanLength{"a length above 0 and of at most 200 m", within(1e-9, 200.0)};
constexpr ScanQuantity scanDirection{"a component of a unit vector", within(-1.01, 1.01)};

/// Sets the end of a cylinder from its start, a unit vector and a length.
/// @return an error message; empty on success.
std::string setEndFromAxis(const glm::dvec3& axis, double length, ScanCylinder& cylinder);

} // namespace osgTreeWind
