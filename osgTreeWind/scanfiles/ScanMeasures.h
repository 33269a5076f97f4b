// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/model/ScannedTree.h>

#include <string>

/// What the readers of scans take for a cylinder. Not part of the interface.
namespace osgTreeWind {

/// A number of a cylinder: what it is, for people, and its range.
struct ScanMeasure {
    const char* what;
    Range range;
};

constexpr ScanMeasure scanMetres{"metres within 1e9", within(-1e9, 1e9)};
constexpr ScanMeasure scanRadius{"a radius above 0 and of at most 10 m", within(1e-9, 10.0)};
constexpr ScanMeasure scanLength{"a length above 0 and of at most 200 m", within(1e-9, 200.0)};
constexpr ScanMeasure scanDirection{"a part of a direction of length 1", within(-1.01, 1.01)};

/// Lets a cylinder end so far from its start along an axis. @return what is wrong with that; empty: nothing.
std::string endAlong(const glm::dvec3& axis, double length, ScanCylinder& cylinder);

} // namespace osgTreeWind
