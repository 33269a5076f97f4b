// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/TreeGeometry.h>

#include <osgTreeWind/drawing/looks/LeafAtlas.h>
#include <osgTreeWind/drawing/looks/SceneGeometry.h>
#include <osgTreeWind/gpu/DistinctArrays.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/laws/Laws.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cstring>

namespace osgTreeWind {
namespace {

constexpr float farthestReach = 4.0f; // metres, as in shaders/instance.glsl

osg::ref_ptr<osg::Geometry> emptyGeometry(const char* name) {
    osg::ref_ptr<osg::Geometry> geometry = new SceneGeometry;
    geometry->setName(name);
    return geometry;
}

/// Packed for shaders/law/shade.glsl.
glm::vec2 packed(const CrownShade::Light& light) {
    return {Laws().packedShares({light.above, light.sky}), Laws().packedShares({light.below, light.ground})};
}

/// Measures the distance along thin wood between points of a tree and thick wood (shaders/law/shoot.glsl).
class ThinWood {
public:
    explicit ThinWood(const Skeleton& skeleton) : _units(skeleton.units) {
        if (skeleton.shoots.empty())
            return; // trees of the thesis have no shoots
        for (const BranchUnit& unit : _units)
            _atBase.push_back(
                unit.parent < 0 ? 0.0f : alongAxis(static_cast<std::size_t>(unit.parent), unit.attach));
    }
    /// @return index of the unit plus a fraction that encodes the distance for shaders/instance.glsl.
    float unitAndReach(int number, const glm::vec3& place) const {
        const auto index = static_cast<std::size_t>(number);
        if (index >= _atBase.size())
            return static_cast<float>(number);
        const BranchUnit& unit = _units[index];
        const glm::vec3 axis = unit.tip - unit.base;
        const float along = glm::clamp(
            glm::dot(place - unit.base, axis) / glm::max(glm::dot(axis, axis), 1e-12f), 0.0f, 1.0f);
        const float aside = glm::distance(place, unit.base + along * axis) - unit.baseRadius;
        const float reach = alongAxis(index, along) + glm::max(aside, 0.0f);
        return static_cast<float>(number) + glm::min(reach / farthestReach, 0.99f);
    }

private:
    static constexpr float thin = 0.012f; ///< Radius, metres.

    float alongAxis(std::size_t index, float part) const {
        const BranchUnit& unit = _units[index];
        const float tapers = unit.baseRadius - unit.tipRadius, from = unit.baseRadius <= thin ? 0.0f
                                                                      : unit.tipRadius < thin
                                                                          ? (unit.baseRadius - thin) / tapers
                                                                          : 1.0f;
        return _atBase[index] + glm::max(part - from, 0.0f) * glm::distance(unit.base, unit.tip);
    }

    const std::vector<BranchUnit>& _units;
    std::vector<float> _atBase; ///< By unit, metres.
};

} // namespace

osg::ref_ptr<osg::Geometry> makeSkinGeometry(const BranchSkin& skin, const Skeleton& skeleton,
                                             const CrownShade& crown) {
    osg::ref_ptr<osg::Vec4Array> centres = new osg::Vec4Array;
    osg::ref_ptr<osg::Vec3Array> outwards = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec3Array> coordinates = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec2Array> shades = new osg::Vec2Array;
    const ThinWood thinWood(skeleton);
    glm::vec3 centre(0.0f);
    glm::vec2 shade(0.0f);
    float unit = 0.0f;
    for (const SkinVertex& v : skin.vertices) {
        if (v.centre != centre || shades->empty()) { // the next ring
            centre = v.centre;
            shade = packed(crown.at(centre));
            unit = thinWood.unitAndReach(static_cast<int>(v.unit + 0.5f), centre);
        }
        shades->push_back({shade.x, shade.y});
        centres->push_back({v.centre.x, v.centre.y, v.centre.z, v.radius});
        outwards->push_back({v.outward.x, v.outward.y, v.outward.z});
        coordinates->push_back({v.uv.x, v.uv.y, unit});
    }
    osg::ref_ptr<osg::Geometry> geometry = emptyGeometry("bark");
    geometry->setVertexArray(centres);
    geometry->setNormalArray(outwards, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, coordinates);
    geometry->setTexCoordArray(1, shades);
    geometry->addPrimitiveSet(new osg::DrawElementsUInt(
        GL_TRIANGLES, static_cast<unsigned>(skin.indices.size()), skin.indices.data()));
    makeArraysDistinct(*geometry);
    return geometry;
}

osg::ref_ptr<osg::Geometry> makeLeafGeometry(const std::vector<LeafCluster>& leaves, const Skeleton& skeleton,
                                             const std::array<LeafVertex, verticesPerLeafCluster>& mesh,
                                             const CrownShade& crown) {
    const ThinnedLeaves whole = thinnedLeaves(leaves, mesh, TreeDetail::full());
    std::vector<glm::vec4> records;
    addLeafRecords(whole, skeleton, mesh, crown, records);
    osg::ref_ptr<osg::Vec4Array> anchors = new osg::Vec4Array, ids = new osg::Vec4Array,
                                 orientations = new osg::Vec4Array, normals = new osg::Vec4Array,
                                 crowns = new osg::Vec4Array;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const glm::vec4* record = &records[leafRecordTexels * i];
        for (std::size_t corner = 0; corner < mesh.size(); ++corner) {
            const LeafVertex& v = mesh[corner];
            const glm::vec2 uv = LeafAtlas::sprayCoordinate(i, corner / 4, v.uv);
            anchors->push_back({record[0].x, record[0].y, record[0].z, record[0].w});
            corners->push_back(toOsg(v.corner));
            ids->push_back({uv.x, uv.y, record[2].w, static_cast<float>(i)});
            orientations->push_back({record[1].x, record[1].y, record[1].z, record[1].w});
            normals->push_back({v.normal.x, v.normal.y, v.normal.z, record[3].x});
            crowns->push_back({record[2].x, record[2].y, record[2].z, record[3].y});
        }
    }
    const std::vector<unsigned> indices = leafIndices(leaves.size());
    osg::ref_ptr<osg::Geometry> geometry = emptyGeometry("leaves");
    geometry->setVertexArray(anchors);
    geometry->setNormalArray(corners, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, ids);
    geometry->setTexCoordArray(1, orientations);
    geometry->setTexCoordArray(2, normals);
    geometry->setTexCoordArray(3, crowns);
    geometry->addPrimitiveSet(
        new osg::DrawElementsUInt(GL_TRIANGLES, static_cast<unsigned>(indices.size()), indices.data()));
    makeArraysDistinct(*geometry);
    return geometry;
}

void addLeafRecords(const ThinnedLeaves& leaves, const Skeleton& skeleton,
                    const std::array<LeafVertex, verticesPerLeafCluster>& mesh, const CrownShade& crown,
                    std::vector<glm::vec4>& records) {
    const ThinWood thinWood(skeleton);
    for (std::size_t i = 0; i < leaves.clusters.size(); ++i) {
        const LeafCluster& leaf = leaves.clusters[i];
        const glm::vec2 shade = packed(crown.at(leaves.middle(i, mesh)));
        const glm::quat& turn = leaf.orientation;
        records.emplace_back(leaf.anchor, leaf.size);
        records.emplace_back(turn.x, turn.y, turn.z, turn.w);
        records.emplace_back(crown.outward(leaf.anchor), thinWood.unitAndReach(leaf.unit, leaf.anchor));
        records.emplace_back(shade, static_cast<float>(leaves.indices[i]), static_cast<float>(leaves.bough));
    }
}

int appendVertices(osg::Geometry& whole, const osg::Geometry& more) {
    osg::Geometry::ArrayList arrays, added;
    whole.getArrayList(arrays);
    more.getArrayList(added);
    const unsigned before = arrays.front()->getNumElements();
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        osg::Array& array = *arrays[i];
        array.resizeArray(before + added[i]->getNumElements());
        std::memcpy(const_cast<GLvoid*>(array.getDataPointer(before)), added[i]->getDataPointer(),
                    added[i]->getTotalDataSize());
    }
    return static_cast<int>(before);
}

std::vector<unsigned> leafIndices(std::size_t clusters) {
    const std::size_t count = quadsPerLeafCluster * clusters;
    std::vector<unsigned> indices;
    indices.reserve(6 * count);
    for (unsigned quad = 0; quad < count; ++quad)
        for (const unsigned corner : {0u, 1u, 2u, 0u, 2u, 3u})
            indices.push_back(4 * quad + corner);
    return indices;
}

} // namespace osgTreeWind
