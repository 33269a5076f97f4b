// SPDX-License-Identifier: MIT
#include <plugins/map/GdalCrs.h>
#include <plugins/map/GdalErrors.h>

#include <osgTreeWind/places/GridMapping.h>

#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace osgTreeWind {

namespace {

/// The names of a parameter of a projection.
struct Number {
    const char *gdalName, *cfName;
};

struct Projection {
    const char *gdalName, *cfName;
    std::array<Number, 6> numbers;
};

constexpr Number easting{SRS_PP_FALSE_EASTING, "false_easting"},
    northing{SRS_PP_FALSE_NORTHING, "false_northing"},
    latitude{SRS_PP_LATITUDE_OF_ORIGIN, "latitude_of_projection_origin"}, none{nullptr, nullptr};

constexpr Projection projections[] = {
    {SRS_PT_TRANSVERSE_MERCATOR,
     "transverse_mercator",
     {{latitude,
       {SRS_PP_CENTRAL_MERIDIAN, "longitude_of_central_meridian"},
       {SRS_PP_SCALE_FACTOR, "scale_factor_at_central_meridian"},
       easting,
       northing,
       none}}},
    {SRS_PT_LAMBERT_CONFORMAL_CONIC_2SP,
     "lambert_conformal_conic",
     {{{SRS_PP_STANDARD_PARALLEL_1, "standard_parallel"},
       {SRS_PP_STANDARD_PARALLEL_2, "standard_parallel"},
       {SRS_PP_CENTRAL_MERIDIAN, "longitude_of_central_meridian"},
       latitude,
       easting,
       northing}}},
    {SRS_PT_LAMBERT_AZIMUTHAL_EQUAL_AREA,
     "lambert_azimuthal_equal_area",
     {{{SRS_PP_LATITUDE_OF_CENTER, "latitude_of_projection_origin"},
       {SRS_PP_LONGITUDE_OF_CENTER, "longitude_of_projection_origin"},
       easting,
       northing,
       none,
       none}}},
};

} // namespace

Result<GridMapping> gridMappingOf(const Crs& crs) {
    const Result<GdalCrs> parsed = GdalCrs::parse(crs.text());
    if (!parsed)
        return parsed.problems();
    const GdalErrors errors;
    const GdalCrs& map = parsed.value();
    GridMapping mapping;
    mapping.wkt = map.wkt();
    const char* const stated = OSRGetAttrValue(map.reference(), "PROJECTION", 0);
    const std::string projection = stated ? stated : "";
    const auto* const known = std::find_if(std::begin(projections), std::end(projections),
                                           [&](const Projection& p) { return projection == p.gdalName; });
    if (known == std::end(projections))
        return mapping;
    mapping.name = known->cfName;
    mapping.numbers = {{"semi_major_axis", {OSRGetSemiMajor(map.reference(), nullptr)}},
                       {"inverse_flattening", {OSRGetInvFlattening(map.reference(), nullptr)}},
                       {"longitude_of_prime_meridian", {OSRGetPrimeMeridian(map.reference(), nullptr)}}};
    for (const Number& number : known->numbers) {
        if (!number.gdalName)
            continue;
        if (mapping.numbers.back().first != number.cfName)
            mapping.numbers.push_back({number.cfName, {}});
        mapping.numbers.back().second.push_back(
            OSRGetNormProjParm(map.reference(), number.gdalName, 0.0, nullptr));
    }
    return mapping;
}

} // namespace osgTreeWind
