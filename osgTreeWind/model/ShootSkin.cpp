// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/ShootSkin.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/model/SkinParts.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <utility>

namespace osgTreeWind {
namespace {

constexpr int shootSides = 3;

/// The ends of a shoot, and the points needed to approximate its course within a tolerance.
std::vector<glm::vec3> courseWithin(const Skeleton& skeleton, const Shoot& shoot, float tolerance) {
    std::vector<glm::vec3> course{skeleton.shootPoint(shoot, 0)};
    for (std::size_t i = 1; i + 1 < shoot.count; ++i) {
        const glm::vec3 point = skeleton.shootPoint(shoot, i), next = skeleton.shootPoint(shoot, i + 1);
        const glm::vec3 along = directionOr(next - course.back(), up);
        const glm::vec3 from = point - course.back();
        if (!(glm::distance(from, glm::dot(from, along) * along) < tolerance))
            course.push_back(point);
    }
    course.push_back(skeleton.shootPoint(shoot, shoot.count - 1));
    return course;
}

void addPrism(const Shoot& shoot, const std::vector<glm::vec3>& course, BranchSkin& skin) {
    const std::size_t first = skin.vertices.size();
    float length = 0.0f;
    for (std::size_t i = 1; i < course.size(); ++i)
        length += glm::distance(course[i - 1], course[i]);
    const float widening = ringWidening(shootSides);
    const float circumference = glm::two_pi<float>() * glm::max(shoot.baseRadius, 1e-6f);
    glm::vec3 tangent = directionOr(course[1] - course[0], up), across = perpendicular(tangent);
    float along = 0.0f;
    SkinVertex vertex;
    vertex.unit = static_cast<float>(shoot.unit);
    for (std::size_t i = 0; i + 1 < course.size(); ++i) {
        tangent = directionOr(course[i + 1] - course[i], tangent);
        across = directionOr(across - tangent * glm::dot(across, tangent), perpendicular(tangent));
        const glm::vec3 beside = glm::cross(tangent, across);
        vertex.centre = course[i];
        vertex.radius =
            widening * glm::mix(shoot.baseRadius, shoot.tipRadius, length > 0.0f ? along / length : 0.0f);
        for (int side = 0; side < shootSides; ++side) {
            const float part = static_cast<float>(side) / shootSides, angle = glm::two_pi<float>() * part;
            vertex.outward = cosine(angle) * across + sine(angle) * beside;
            vertex.uv = {2.0f * part, along / circumference};
            skin.vertices.push_back(vertex);
        }
        along += glm::distance(course[i], course[i + 1]);
    }
    vertex.centre = course.back();
    vertex.radius = shoot.tipRadius;
    vertex.outward = tangent;
    vertex.uv = {1.0f, along / circumference};
    skin.vertices.push_back(vertex);
    addRingTriangles(skin, first, static_cast<int>(course.size()) - 1, shootSides, true);
}

} // namespace

void addShootSkin(const Skeleton& skeleton, float tolerance, float thinnest, BranchSkin& skin) {
    if (skeleton.shoots.empty())
        return;
    BranchSkin whole;
    auto shoot = skeleton.shoots.begin();
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
        const std::uint32_t before = skin.firstVertices[unit], now = whole.firstVertices.back();
        whole.vertices.insert(whole.vertices.end(), skin.vertices.begin() + before,
                              skin.vertices.begin() + skin.firstVertices[unit + 1]);
        for (std::uint32_t i = skin.firstIndices[unit]; i < skin.firstIndices[unit + 1]; ++i)
            whole.indices.push_back(skin.indices[i] - before + now);
        for (; shoot != skeleton.shoots.end() && shoot->unit == static_cast<int>(unit); ++shoot)
            if (shoot->baseRadius >= thinnest)
                addPrism(*shoot, courseWithin(skeleton, *shoot, tolerance), whole);
        whole.firstVertices.push_back(static_cast<std::uint32_t>(whole.vertices.size()));
        whole.firstIndices.push_back(static_cast<std::uint32_t>(whole.indices.size()));
    }
    skin = std::move(whole);
}

SkinSize sizeOfShootSkin(const Skeleton& skeleton) {
    SkinSize size;
    for (const Shoot& shoot : skeleton.shoots) {
        size.vertices += shootSides * (shoot.count - 1) + 1;
        size.triangles += 2 * shootSides * (shoot.count - 2) + shootSides;
    }
    return size;
}

} // namespace osgTreeWind
