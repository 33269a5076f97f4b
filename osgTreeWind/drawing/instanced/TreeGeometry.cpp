// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/TreeGeometry.h>

#include <osgTreeWind/drawing/looks/LeafAtlas.h>
#include <osgTreeWind/drawing/looks/SceneGeometry.h>
#include <osgTreeWind/gpu/DistinctArrays.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/motion/laws/Laws.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

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

/// Values that the vertices of a ring share.
class RingValues {
public:
    RingValues(const Skeleton& skeleton, const CrownShade& crown) : _thinWood(skeleton), _crown(crown) {}
    void update(const SkinVertex& vertex) {
        if (vertex.centre == _centre && _isSet)
            return;
        _isSet = true;
        _centre = vertex.centre;
        shade = packed(_crown.at(_centre));
        unitAndReach = _thinWood.unitAndReach(static_cast<int>(vertex.unit + 0.5f), _centre);
    }
    glm::vec2 shade{0.0f};
    float unitAndReach = 0.0f;

private:
    const ThinWood _thinWood;
    const CrownShade& _crown;
    glm::vec3 _centre{0.0f};
    bool _isSet = false;
};

/// Rounds to a whole number. @param most the value of the largest number.
std::uint32_t steps(float value, float most, std::uint32_t largest) {
    return static_cast<std::uint32_t>(
        std::lround(glm::clamp(value / most, 0.0f, 1.0f) * static_cast<float>(largest)));
}

/// A unit vector on an octahedron that is unfolded to a square (Meyer et al. 2010), in [0, 1].
glm::vec2 onOctahedron(const glm::vec3& v) {
    const glm::vec2 top = glm::vec2(v) / (std::abs(v.x) + std::abs(v.y) + std::abs(v.z));
    const glm::vec2 sides(top.x < 0.0f ? -1.0f : 1.0f, top.y < 0.0f ? -1.0f : 1.0f);
    return 0.5f + 0.5f * (v.z < 0.0f ? sides * (1.0f - glm::abs(glm::vec2(top.y, top.x))) : top);
}

/// Ranges of the values of packed bark.
struct BarkRanges {
    glm::vec3 low{std::numeric_limits<float>::max()}, size{1e-9f}; ///< Box of the centres, m.
    float radius = 1e-9f;                                          ///< Largest radius, m.
    float v = 1e-9f;                                               ///< Largest texture coordinate.

    explicit BarkRanges(const std::vector<BranchSkin>& skins) {
        glm::vec3 high(std::numeric_limits<float>::lowest());
        for (const BranchSkin& skin : skins)
            for (const SkinVertex& vertex : skin.vertices) {
                low = glm::min(low, vertex.centre);
                high = glm::max(high, vertex.centre);
                radius = glm::max(radius, vertex.radius);
                v = glm::max(v, vertex.uv.y);
            }
        size = glm::max(size, high - low);
    }
};

} // namespace

osg::ref_ptr<osg::Geometry> makeSkinGeometry(const BranchSkin& skin, const Skeleton& skeleton,
                                             const CrownShade& crown) {
    osg::ref_ptr<osg::Vec4Array> centres = new osg::Vec4Array;
    osg::ref_ptr<osg::Vec3Array> outwards = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec3Array> coordinates = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec2Array> shades = new osg::Vec2Array;
    RingValues ring(skeleton, crown);
    for (const SkinVertex& v : skin.vertices) {
        ring.update(v);
        shades->push_back({ring.shade.x, ring.shade.y});
        centres->push_back({v.centre.x, v.centre.y, v.centre.z, v.radius});
        outwards->push_back({v.outward.x, v.outward.y, v.outward.z});
        coordinates->push_back({v.uv.x, v.uv.y, ring.unitAndReach});
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

osg::ref_ptr<osg::Geometry> makePackedBark(const std::vector<BranchSkin>& skins, const Skeleton& skeleton,
                                           const CrownShade& crown, osg::StateSet& state) {
    const BarkRanges most(skins);
    std::size_t count = 0;
    for (const BranchSkin& skin : skins)
        count += skin.vertices.size();
    osg::ref_ptr<osg::Vec4uiArray> places = new osg::Vec4uiArray;
    osg::ref_ptr<osg::Vec2uiArray> shades = new osg::Vec2uiArray;
    places->reserveArray(static_cast<unsigned>(count));
    shades->reserveArray(static_cast<unsigned>(count));
    for (osg::Array* words : {static_cast<osg::Array*>(places), static_cast<osg::Array*>(shades)})
        words->setPreserveDataType(true);
    RingValues ring(skeleton, crown);
    for (const BranchSkin& skin : skins)
        for (const SkinVertex& vertex : skin.vertices) {
            ring.update(vertex);
            const glm::vec3 centre = vertex.centre - most.low;
            const glm::vec2 outward = onOctahedron(vertex.outward);
            const std::uint32_t v = steps(vertex.uv.y, most.v, 0xffff);
            std::uint32_t unit = 0;
            std::memcpy(&unit, &ring.unitAndReach, sizeof unit);
            places->push_back(
                {steps(centre.x, most.size.x, 0xffff) | steps(centre.y, most.size.y, 0xffff) << 16,
                 steps(centre.z, most.size.z, 0xffff) |
                     steps(std::sqrt(vertex.radius), std::sqrt(most.radius), 0xffff) << 16,
                 steps(outward.x, 1.0f, 0xfff) | steps(outward.y, 1.0f, 0xfff) << 12 |
                     steps(vertex.uv.x, 2.0f, 240) << 24,
                 unit});
            shades->push_back({steps(ring.shade.x, 1.0f, 1u << 24) << 8 | v >> 8,
                               steps(ring.shade.y, 1.0f, 1u << 24) << 8 | (v & 0xff)});
        }
    state.addUniform(new osg::Uniform("barkLow", toOsg(most.low)));
    state.addUniform(new osg::Uniform("barkSize", toOsg(most.size)));
    state.addUniform(new osg::Uniform("barkMost", osg::Vec2(most.radius, most.v)));
    osg::ref_ptr<osg::Geometry> geometry = emptyGeometry("bark");
    geometry->setVertexAttribArray(barkPlaceLocation, places, osg::Array::BIND_PER_VERTEX);
    geometry->setVertexAttribArray(barkSharesLocation, shades, osg::Array::BIND_PER_VERTEX);
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
