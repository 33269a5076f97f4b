// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

#include <memory>

namespace osgTreeWind {

/// A coordinate reference system as GDAL holds it.
class GdalCrs {
public:
    /// As Crs::parse().
    static Result<GdalCrs> parse(const std::string& text);

    GdalCrs() = default;
    /// @param reference an OGRSpatialReferenceH, which becomes its own; its order of axes counts, and nothing
    /// that it says of heights.
    explicit GdalCrs(void* reference);

    /// The same as a value without GDAL.
    Crs crs() const;
    void* reference() const { return _reference.get(); }

private:
    std::string name() const;
    std::string text() const;
    std::string problemOfMap() const;

    std::shared_ptr<void> _reference;
};

/// A system as PROJ writes it; its name where that cannot.
std::string projText(const Crs& crs);

} // namespace osgTreeWind
