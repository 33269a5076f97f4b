// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/canopy/CanopyRows.h>

#include <memory>
#include <string>

/// What a file says beside its numbers.
struct CanopyHead {
    osgTreeWind::CanopyGrid grid;
    std::string crs;     ///< Of the grid, as ForestDescription has it; empty: none.
    float season = 0.0f; ///< Of the year.
};

/// A file that takes a canopy row by row, from the south.
class CanopyFile {
public:
    virtual ~CanopyFile() = default;
    /// False once there is a problem.
    virtual bool write(const osgTreeWind::CanopyRow& row) = 0;
    virtual bool close() = 0;
    virtual std::string problem() const = 0;
};

/// NetCDF in the format of PALM's static driver: `lad` and `cda` over zlad, y and x.
std::unique_ptr<CanopyFile> createPalmCanopy(const std::string& path, const CanopyHead& head);
/// NetCDF by the CF conventions: the same over z, y and x of the map.
std::unique_ptr<CanopyFile> createCfCanopy(const std::string& path, const CanopyHead& head);
/// A VTK image, .vti, with the same as data of its cells.
std::unique_ptr<CanopyFile> createVtkCanopy(const std::string& path, const CanopyHead& head);
