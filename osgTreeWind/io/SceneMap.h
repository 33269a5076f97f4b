// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/DocumentTrees.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TableReader.h>
#include <osgTreeWind/places/CrsTransform.h>

#include <optional>

namespace osgTreeWind {

/// The map of the scene: that of the document's places, or a UTM zone if that map is stretched.
class SceneMap {
public:
    /// @param forest gets the CRS; must outlive this object.
    explicit SceneMap(ForestFile& forest) : _forest(forest) {}

    /// Reads `crs`, which the forest holds, and `stretched`.
    void read(TableReader& root);
    /// The CRS of the scene, if it is known.
    const std::optional<Crs>& crs() const { return _crs; }
    /// Sets the CRS that an inventory or the ground requires.
    void set(const Crs& crs);

    /// The number of metres on `map` for one metre of the scene at a place: scaleOfMap(), or 1 if the file
    /// keeps the scene on the map (`stretched = true`).
    double metresAt(const glm::dvec2& place, const Crs& map) const;
    /// The CRS for a scene at a place: `map`, or the UTM zone of the place if metresAt() is not 1, with a
    /// note.
    Result<Crs> crsAt(const glm::dvec2& place, const Crs& map, TableReader& table) const;

    /// Reprojects the trees read so far to crsAt() their centre, and what is read later with toScene().
    /// Does not affect forests in tiles.
    void reproject(DocumentTrees& trees, TableReader& table);
    bool isReprojected() const { return !_transform.isIdentity(); }
    /// Transforms a place of the file.
    glm::dvec3 toScene(const glm::dvec3& place) const;

private:
    ForestFile& _forest;
    std::optional<Crs> _crs;
    bool _keepsStretched = false;
    CrsTransform _transform; ///< From the file's map to the scene.
};

} // namespace osgTreeWind
