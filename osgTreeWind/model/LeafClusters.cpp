// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/LeafClusters.h>

#include <osgTreeWind/base/ClampOr.h>
#include <osgTreeWind/model/PortableMath.h>
#include <osgTreeWind/model/Random.h>
#include <osgTreeWind/model/UnitVectors.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>

namespace osgTreeWind {
namespace {

constexpr float goldenAngle = 2.3999632f;

/// The leaf frame whose petiole (+Z) points along `petiole`, turned by `roll` about it.
glm::quat leafFrame(const glm::vec3& petiole, float roll) {
    const glm::vec3 z{0.0f, 0.0f, 1.0f};
    const float rise = petiole.z;
    const glm::quat swing = rise < -0.9999f ? glm::quat(0.0f, 1.0f, 0.0f, 0.0f)
                                            : glm::normalize(glm::quat(1.0f + rise, glm::cross(z, petiole)));
    return swing * glm::quat(cosine(0.5f * roll), sine(0.5f * roll) * z);
}

} // namespace

LeafParameters clamped(LeafParameters p) {
    const LeafParameters usual;
    p.clustersPerBranch = glm::clamp(p.clustersPerBranch, 0, 64);
    p.firstLevel = glm::clamp(p.firstLevel, 0, 9);
    p.length = clampOr(p.length, 0.001f, 100.0f, usual.length);
    p.width = clampOr(p.width, 0.001f, 100.0f, usual.width);
    p.innerSize = clampOr(p.innerSize, 0.01f, 1.0f, usual.innerSize);
    p.droop = clampOr(p.droop, -1.0f, 1.0f, usual.droop);
    return p;
}

std::vector<LeafCluster> makeLeafClusters(const Skeleton& skeleton, const LeafParameters& wanted) {
    const LeafParameters parameters = clamped(wanted);
    int lastLevel = 0;
    for (const BranchUnit& unit : skeleton.units)
        lastLevel = std::max(lastLevel, unit.level);
    const float levels = static_cast<float>(std::max(lastLevel - parameters.firstLevel, 1));
    const int count = parameters.clustersPerBranch;

    Random random(parameters.seed);
    std::vector<LeafCluster> clusters;
    for (std::size_t index = 0; index < skeleton.units.size(); ++index) {
        const BranchUnit& unit = skeleton.units[index];
        if (unit.level < parameters.firstLevel)
            continue;
        const float outerness = static_cast<float>(unit.level - parameters.firstLevel) / levels;
        const float levelSize =
            lastLevel == parameters.firstLevel ? 1.0f : glm::mix(parameters.innerSize, 1.0f, outerness);
        const float start = random.uniform() * glm::two_pi<float>();
        for (int i = 0; i < count; ++i) {
            const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
            const float place = t * static_cast<float>(skeleton.ringsPerBranch - 1);
            const int ring = std::min(static_cast<int>(place), skeleton.ringsPerBranch - 2);
            const glm::vec3 tangent = skeleton.tangent(index, ring);
            const glm::vec3 e1 = perpendicular(tangent);
            const float around = start + goldenAngle * static_cast<float>(i) + 0.5f * random.symmetric();
            const glm::vec3 outward = cosine(around) * e1 + sine(around) * glm::cross(tangent, e1);
            const glm::vec3 stand = outward + (0.35f + 0.45f * t) * tangent;
            const glm::vec3 petiole = directionOr(stand - glm::vec3(0, 0, parameters.droop * 1.2f), outward);

            LeafCluster cluster;
            cluster.anchor = glm::mix(skeleton.point(index, ring), skeleton.point(index, ring + 1),
                                      place - static_cast<float>(ring));
            cluster.unit = static_cast<int>(index);
            cluster.orientation = leafFrame(petiole, random.symmetric() * glm::pi<float>());
            cluster.size = levelSize * (1.0f + 0.25f * random.symmetric());
            clusters.push_back(cluster);
        }
    }
    return clusters;
}

std::array<LeafVertex, verticesPerLeafCluster> makeLeafMesh(const LeafParameters& wanted) {
    const LeafParameters parameters = clamped(wanted);
    std::array<LeafVertex, verticesPerLeafCluster> mesh;
    const float half = 0.5f * parameters.width;
    for (int quad = 0; quad < quadsPerLeafCluster; ++quad) {
        // A fan about the petiole; each quad leans away from it so that the cluster fills a volume.
        const float turn = glm::two_pi<float>() * static_cast<float>(quad) / quadsPerLeafCluster;
        const glm::vec3 side{cosine(turn), sine(turn), 0.0f};
        const glm::vec3 away{-sine(turn), cosine(turn), 0.0f};
        const glm::vec3 along = cosine(0.5f) * glm::vec3(0, 0, 1) + sine(0.5f) * away;
        const glm::vec3 normal = glm::cross(side, along);
        for (int corner = 0; corner < 4; ++corner) {
            const glm::vec2 uv{corner == 1 || corner == 2 ? 1.0f : 0.0f, corner >= 2 ? 1.0f : 0.0f};
            mesh[static_cast<std::size_t>(4 * quad + corner)] = {
                side * (2.0f * uv.x - 1.0f) * half + along * uv.y * parameters.length, normal, uv};
        }
    }
    return mesh;
}

} // namespace osgTreeWind
