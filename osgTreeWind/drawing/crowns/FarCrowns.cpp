// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/crowns/FarCrowns.h>

#include <osgTreeWind/drawing/looks/SceneGeometry.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/species/Season.h>

#include <osg/Geometry>

#include <glm/common.hpp>

#include <algorithm>
#include <map>

namespace osgTreeWind {
namespace {

constexpr std::size_t maxSpecies = 128; // as in shaders/crowns.vert; further species look like the last one

/// Builds the billboards of the cells of one tile.
class CellGeometry {
public:
    void add(const CrownCell& cell, const glm::vec3& middle, float side, std::size_t species) {
        for (const float t : {0.0f, 1.0f})
            for (const float s : {-1.0f, 1.0f}) {
                _corners->push_back({s, t, 0.0f});
                _places->push_back({middle.x, middle.y, middle.z, side});
                _crowns->push_back({static_cast<float>(cell.trees), cell.height, cell.width,
                                    static_cast<float>(std::min(species, maxSpecies - 1))});
            }
        const unsigned first = static_cast<unsigned>(_corners->size()) - 4;
        for (const unsigned i : {0u, 1u, 3u, 0u, 3u, 2u})
            _indices->push_back(first + i);
        const osg::Vec3 centre(middle.x, middle.y, middle.z + 0.5f * cell.height);
        const float reach = 0.75f * side + cell.height;
        _box.expandBy(centre - osg::Vec3(reach, reach, reach));
        _box.expandBy(centre + osg::Vec3(reach, reach, reach));
    }

    osg::ref_ptr<osg::Geometry> geometry() const {
        osg::ref_ptr<osg::Geometry> geometry = new SceneGeometry;
        geometry->setName("far crowns");
        geometry->setVertexArray(_corners);
        geometry->setVertexAttribArray(treePlaceLocation, _places, osg::Array::BIND_PER_VERTEX);
        geometry->setVertexAttribArray(treeSizeLocation, _crowns, osg::Array::BIND_PER_VERTEX);
        geometry->addPrimitiveSet(_indices);
        geometry->setInitialBound(_box);
        geometry->setComputeBoundingBoxCallback(new Bounds(_box));
        return geometry;
    }

private:
    struct Bounds : osg::Drawable::ComputeBoundingBoxCallback {
        explicit Bounds(const osg::BoundingBox& given) : box(given) {}
        osg::BoundingBox computeBound(const osg::Drawable&) const override { return box; }
        osg::BoundingBox box;
    };

    osg::ref_ptr<osg::Vec3Array> _corners = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> _places = new osg::Vec4Array, _crowns = new osg::Vec4Array;
    osg::ref_ptr<osg::DrawElementsUShort> _indices = new osg::DrawElementsUShort(GL_TRIANGLES);
    osg::BoundingBox _box;
};

} // namespace

FarCrowns::FarCrowns(const CrownSummary& summary, const ForestDescription& world)
    : _species(world.species), _tiles(world.tiles->tiles.size()),
      _colors(new osg::Uniform(osg::Uniform::FLOAT_VEC4, "crownColors", maxSpecies)) {
    setName("far crowns");
    osg::StateSet* state = getOrCreateStateSet();
    state->setAttributeAndModes(sharedProgram("crowns", "crowns"), protectedProgram);
    drawBothSides(*state);
    clipByAllPlanes(*state);
    state->addUniform(_colors);
    state->addUniform(new osg::Uniform("tierColor", osg::Vec3(0.5f, 0.05f, 1.0f)));
    const ForestTiles& tiles = *world.tiles;
    const std::uint32_t across = CrownSummary::cellsAcrossTile(tiles);
    const double side = tiles.size / across;
    std::map<std::size_t, CellGeometry> geometries; // by tile
    for (const CrownCell& cell : summary.cells) {
        const std::size_t column = cell.column / across, tile = cell.row / across * tiles.columns + column;
        const auto species = std::find_if(_species.begin(), _species.end(), [&](const Species& each) {
            return each.name == summary.species[cell.species];
        });
        if (column >= tiles.columns || tile >= _tiles.size() || species == _species.end())
            continue;
        const glm::dvec2 middle = tiles.corner + side * (glm::dvec2(cell.column, cell.row) + 0.5);
        geometries[tile].add(cell,
                             glm::vec3(glm::dvec3(middle, static_cast<double>(cell.foot)) - world.origin),
                             static_cast<float>(side), static_cast<std::size_t>(species - _species.begin()));
    }
    for (const auto& [tile, cells] : geometries) {
        _tiles[tile] = cells.geometry();
        addChild(_tiles[tile]);
    }
    showSeason(world.season);
}

FarCrowns::~FarCrowns() = default;

void FarCrowns::setTileVisible(std::size_t tile, bool visible) {
    if (tile < _tiles.size() && _tiles[tile])
        _tiles[tile]->setNodeMask(visible ? ~0u : 0u);
}

void FarCrowns::showSeason(float season) {
    for (std::size_t i = 0; i < std::min(_species.size(), maxSpecies); ++i) {
        const Appearance& appearance = _species[i].appearance;
        const float leaves = leafShare(appearance, season);
        const glm::vec3 color = glm::mix(appearance.bark, leafColor(appearance, season), leaves);
        _colors->setElement(static_cast<unsigned>(i), osg::Vec4(toOsg(color), leaves));
    }
}

} // namespace osgTreeWind
