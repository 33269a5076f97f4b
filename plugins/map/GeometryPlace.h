// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsTransform.h>
#include <osgTreeWind/places/MapMessages.h>

#include <string>
#include <vector>

namespace osgTreeWind {

/// The place of an OGRGeometryH: a point, or the centroid of an outline. Null is an error.
/// @param isYFirst whether its coordinates are (y, x), such as latitude and longitude; they are exchanged.
Result<VectorPlace> placeOfGeometry(void* geometry, const CrsTransform& transform, bool isYFirst);

/// The places of geometries as WKT, GeoJSON, or hexadecimal WKB or EWKB.
GeometryBatch placesOfTexts(const std::vector<std::string>& texts, const CrsTransform& transform,
                            bool isYFirst);

} // namespace osgTreeWind
