// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsMesh.h>
#include <osgTreeWind/places/Ground.h>
#include <osgTreeWind/places/Raster.h>

namespace osgTreeWind {

/// Rasters of heights as the ground of a forest on any map. Several are tiles of one: the first that has a
/// place counts.
class RasterGround final : public Ground {
public:
    /// What a file says of it.
    struct Source {
        std::vector<std::string> files;
        std::string crs;    ///< Of all of them, whatever they say; empty: what they say.
        std::string band{}; ///< Name or number of that of the heights; empty: the only one, or by its name.
    };
    /// @param map of the world; none: that of the first file, or for what is no map in metres the UTM zone of
    /// its middle, or none where no file says any.
    static Result<std::shared_ptr<const RasterGround>> open(const Source& source, std::optional<Crs> map);

    const Source& source() const { return _source; }
    /// Of the world.
    const std::optional<Crs>& map() const { return _map; }

    std::optional<double> height(const glm::dvec2& place) const override;
    GroundArea area() const override { return _area; }

private:
    struct Tile {
        Raster raster;
        bool isDegrees = false;
        std::optional<CrsMesh> way{}; ///< From the map; nothing: it lies on the map.
    };
    Diagnostics add(const std::string& file, MapProgram& program);
    Diagnostics chooseMap(const Raster& raster, const Crs& crs);
    Diagnostics lay(Tile& tile, const std::optional<Crs>& crs);

    Source _source;
    std::optional<Crs> _map, _given;
    std::vector<Tile> _tiles;
    GroundArea _area;
};

} // namespace osgTreeWind
