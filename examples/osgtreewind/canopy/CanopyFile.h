// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/canopy/CanopyRows.h>

#include <memory>
#include <string>

/// Metadata of a canopy file.
struct CanopyHead {
    osgTreeWind::CanopyGrid grid;
    std::string crs;     ///< Map projection as in ForestDescription; empty if unknown.
    float season = 0.0f; ///< As in species/Season.h.
};

/// File to which a canopy is written row by row, from the south.
class CanopyFile {
public:
    virtual ~CanopyFile() = default;
    /// @return false after an error.
    virtual bool write(const osgTreeWind::CanopyRow& row) = 0;
    virtual bool close() = 0;
    virtual std::string problem() const = 0;
};

/// NetCDF in the format of PALM's static driver: `lad` and `cda` over zlad, y and x.
std::unique_ptr<CanopyFile> createPalmCanopy(const std::string& path, const CanopyHead& head);
/// NetCDF after the CF conventions: the same arrays over z, y and x of the map.
std::unique_ptr<CanopyFile> createCfCanopy(const std::string& path, const CanopyHead& head);
/// VTK image (.vti) with the same arrays as cell data.
std::unique_ptr<CanopyFile> createVtkCanopy(const std::string& path, const CanopyHead& head);
