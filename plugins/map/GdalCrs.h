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
    /// @param reference an OGRSpatialReferenceH, whose ownership it takes. Uses its order of axes, and
    /// removes its vertical part.
    explicit GdalCrs(void* reference);

    /// The system as a value without GDAL.
    Crs crs() const;
    void* reference() const { return _reference.get(); }
    std::string wkt() const; ///< WKT 2, on one line.

private:
    std::string name() const;
    std::string text() const;
    std::string problemOfMap() const;

    std::shared_ptr<void> _reference;
};

/// The PROJ string of a system, or its name if there is none.
std::string projText(const Crs& crs);

} // namespace osgTreeWind
