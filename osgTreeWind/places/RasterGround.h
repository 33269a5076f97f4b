// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsMesh.h>
#include <osgTreeWind/places/Ground.h>
#include <osgTreeWind/places/Raster.h>

namespace osgTreeWind {

/// A ground from one or more height rasters, reprojected to the forest's CRS. Where rasters overlap, the
/// first one that has a height counts.
class RasterGround final : public Ground {
public:
    /// The ground's section of a .treewind file.
    struct Source {
        std::vector<std::string> files;
        std::string crs;    ///< Overrides the CRSs of the files, if not empty.
        std::string band{}; ///< As in Raster::open().
    };
    /// @param map CRS of the world. If empty, it is that of the first file, or the UTM zone of the file's
    /// centre if that CRS is not projected in metres, or none if no file has a CRS.
    static Result<std::shared_ptr<const RasterGround>> open(const Source& source, std::optional<Crs> map);

    const Source& source() const { return _source; }
    /// CRS of the world.
    const std::optional<Crs>& map() const { return _map; }

    std::optional<double> height(const glm::dvec2& place) const override;
    GroundArea area() const override { return _area; }

private:
    struct Tile {
        Raster raster;
        bool isDegrees = false;
        std::optional<CrsMesh> fromMap{}; ///< Empty for the identity.
    };
    Diagnostics add(const std::string& file, MapProgram& program);
    Diagnostics chooseMap(const Raster& raster, const Crs& crs);
    Diagnostics placeTile(Tile& tile, const std::optional<Crs>& crs);

    Source _source;
    std::optional<Crs> _map, _sourceCrs;
    std::vector<Tile> _tiles;
    GroundArea _area;
};

} // namespace osgTreeWind
