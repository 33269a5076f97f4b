// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/LeafClusters.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/model/TreeKeys.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr float goldenAngle = 2.3999632f;
/// Clusters per metre on a trunk's leafy end, over those on other shoots: a leader is clad all around.
constexpr float leaderWeight = 3.0f;
/// Mean inclination of clusters / that of leaf faces; the leaves on a cluster add the rest.
constexpr float clusterShare = 0.9f;
/// Angle between half of a leaf and its face, radians, which the quads at the sides of a spray have: 5
/// degrees in the shade to 45 degrees at the top of beeches (Fleck et al. 2003, Tree Physiology 23:577).
constexpr float leafFold = 0.6f;
constexpr float leanSpread = 0.7f; ///< Faces lean outward, within this share of half a turn.
/// Inclination of hanging shoots and of the row on top, over the mean inclination, which they have together.
constexpr float hangingShare = 1.2f, lyingShare = 0.3f;
constexpr float hangingWidth = 0.85f; ///< Width of a hanging shoot over that of a spray of the same area.
constexpr float onward = 0.7f;        ///< Forward lean of a hanging shoot along its twig, radians.
constexpr float rowAngle = 1.22f;     ///< Angle between the rows of a frond and the upright, radians.

/// The leaf frame whose petiole (+Z) points along `petiole`, turned by `roll` about it.
glm::quat leafFrame(const glm::vec3& petiole, float roll) {
    const glm::vec3 z{0.0f, 0.0f, 1.0f};
    const float rise = petiole.z;
    const glm::quat swing = rise < -0.9999f ? glm::quat(0.0f, 1.0f, 0.0f, 0.0f)
                                            : glm::normalize(glm::quat(1.0f + rise, glm::cross(z, petiole)));
    return swing * glm::quat(math::cos(0.5f * roll), math::sin(0.5f * roll) * z);
}

int lastLevelOf(const Skeleton& skeleton) {
    int last = 0;
    for (const BranchUnit& unit : skeleton.units)
        last = std::max(last, unit.level);
    return last;
}

/// The part of a unit, or of one of its shoots, that bears clusters, in metres from its base.
struct Stretch {
    std::size_t unit = 0;
    const Shoot* shoot = nullptr;
    float from = 0.0f, to = 0.0f;
    float length = 0.0f; ///< Of the unit or shoot.
    float weight = 1.0f; ///< Clusters per metre relative to other stretches.

    float share() const { return weight * std::max(to - from, 0.0f); }
};

float lengthOf(const Skeleton& skeleton, const Shoot& shoot) {
    float length = 0.0f;
    for (std::size_t i = 1; i < shoot.count; ++i)
        length += glm::distance(skeleton.shootPoint(shoot, i - 1), skeleton.shootPoint(shoot, i));
    return length;
}

/// The radius below which lies `share` of the length of all wood, by units and shoots. @param length of
/// units.
float radiusQuantile(const Skeleton& skeleton, const std::vector<float>& length, float share) {
    std::vector<std::pair<float, float>> wood; // radius, length
    for (std::size_t i = 0; i < length.size(); ++i)
        wood.emplace_back(0.5f * (skeleton.units[i].baseRadius + skeleton.units[i].tipRadius), length[i]);
    for (const Shoot& shoot : skeleton.shoots)
        wood.emplace_back(0.5f * (shoot.baseRadius + shoot.tipRadius), lengthOf(skeleton, shoot));
    float left = 0.0f;
    for (const auto& piece : wood)
        left += share * piece.second;
    std::sort(wood.begin(), wood.end());
    std::size_t i = 0;
    for (; i + 1 < wood.size() && left > wood[i].second; ++i)
        left -= wood[i].second;
    return wood[i].first;
}

float lengthOf(const Skeleton& skeleton, std::size_t unit) {
    float length = 0.0f;
    for (int ring = 1; ring < skeleton.ringsPerBranch; ++ring)
        length += glm::distance(skeleton.point(unit, ring - 1), skeleton.point(unit, ring));
    return length;
}

/// The stretches given by the skeleton.
std::vector<Stretch> stretchesOfSkeleton(const Skeleton& skeleton) {
    std::vector<Stretch> stretches;
    const auto add = [&](std::size_t unit, const Shoot* shoot, const BranchPart& leafy, float length) {
        const bool leader = !shoot && skeleton.units[unit].level == 0;
        stretches.push_back(
            {unit, shoot, leafy.from, std::min(leafy.to, length), length, leader ? leaderWeight : 1.0f});
    };
    auto shoot = skeleton.shoots.begin();
    for (std::size_t i = 0; i < skeleton.units.size(); ++i) {
        add(i, nullptr, skeleton.leafyUnits[i], lengthOf(skeleton, i));
        for (; shoot != skeleton.shoots.end() && shoot->unit == static_cast<int>(i); ++shoot)
            add(i, &*shoot, shoot->leafy, lengthOf(skeleton, *shoot));
    }
    return stretches;
}

std::vector<Stretch> leafyStretches(const Skeleton& skeleton, const LeafParameters& p) {
    if (!skeleton.leafyUnits.empty())
        return stretchesOfSkeleton(skeleton);
    const std::vector<BranchUnit>& units = skeleton.units;
    const auto levels = static_cast<float>(std::max(lastLevelOf(skeleton) - p.firstLevel, 1));
    std::vector<float> length(units.size()), before(units.size()); // of the unit; of its branch below that
    std::vector<float> branch(units.size()); // length of the branch that begins with the unit
    std::vector<std::size_t> first(units.size());
    for (std::size_t i = 0; i < units.size(); ++i) {
        length[i] = lengthOf(skeleton, i);
        first[i] = i;
        const auto parent = static_cast<std::size_t>(std::max(units[i].parent, 0));
        if (units[i].parent >= 0 && units[parent].level == units[i].level) {
            first[i] = first[parent];
            before[i] = branch[first[i]];
        }
        branch[first[i]] += length[i];
    }
    const float thickest =
        p.thinWood < 1.0f ? radiusQuantile(skeleton, length, p.thinWood) : std::numeric_limits<float>::max();
    /// Length, from the base of a piece of wood, over which it is too thick.
    const auto below = [&](float base, float tip, float whole) {
        const float thick = std::max(base - thickest, 0.0f), taper = base - tip;
        return thick < taper ? whole * thick / taper : thick > 0.0f ? whole : 0.0f;
    };
    std::vector<Stretch> stretches;
    stretches.reserve(units.size() + skeleton.shoots.size());
    auto shoot = skeleton.shoots.begin();
    for (std::size_t i = 0; i < units.size(); ++i) {
        const float outerness = static_cast<float>(units[i].level - p.firstLevel) / levels;
        Stretch stretch{i};
        if (outerness >= 0.0f) {
            stretch.from = std::max(p.bare * (1.0f - outerness) * branch[first[i]] - before[i],
                                    below(units[i].baseRadius, units[i].tipRadius, length[i]));
            stretch.to = stretch.length = length[i];
        }
        stretches.push_back(stretch);
        for (; shoot != skeleton.shoots.end() && shoot->unit == static_cast<int>(i); ++shoot) {
            const float whole = lengthOf(skeleton, *shoot);
            stretches.push_back(
                {i, &*shoot, below(shoot->baseRadius, shoot->tipRadius, whole), whole, whole});
        }
    }
    return stretches;
}

/// Draws from a beta distribution on (0, 1) (Jöhnk).
float drawBeta(Random& random, float alpha, float beta) {
    for (int tries = 0; tries < 1000; ++tries) {
        const float x = math::pow(random.uniform(), 1.0f / alpha),
                    y = math::pow(random.uniform(), 1.0f / beta);
        if (x + y > 0.0f && x + y <= 1.0f)
            return x / (x + y);
    }
    return alpha / (alpha + beta);
}

/// Random angle of a leaf face from the horizontal: a beta distribution (Goel and Strebel 1984) with the
/// standard deviation of measured crowns, 13 to 20 degrees.
float leafAngle(Random& random, float mean) {
    constexpr float concentration = 4.0f;
    const float m = mean / glm::half_pi<float>();
    return glm::half_pi<float>() * drawBeta(random, concentration * m, concentration * (1.0f - m));
}

/// Attachment of a cluster to a branch: the direction of the branch, and a normal.
struct LeafAttachment {
    glm::vec3 anchor, tangent, outward;
};

/// The leaf frame of a flat spray. Its petiole points along `outward` as far as the inclination allows.
/// @param angle of its faces from the horizontal. @param turn azimuth of their lean off outward.
glm::quat sprayFrame(const LeafAttachment& attachment, const glm::vec3& outward, float angle, float turn) {
    const glm::vec2 out(
        directionOr(glm::vec3(attachment.anchor.x, attachment.anchor.y, 0.0f), glm::vec3(1, 0, 0)));
    const float along = math::cos(turn), across = math::sin(turn);
    const glm::vec3 normal{math::sin(angle) * (along * out.x - across * out.y),
                           math::sin(angle) * (across * out.x + along * out.y), math::cos(angle)};
    const glm::vec3 petiole =
        directionOr(outward - normal * glm::dot(normal, outward), perpendicular(normal));
    return glm::quat_cast(glm::mat3(glm::cross(petiole, normal), -normal, petiole));
}

/// The leaf frame of a segment of a frond: petiole along it, face up.
glm::quat frondFrame(const glm::vec3& along) {
    const glm::vec3 up = directionOr(glm::vec3(0, 0, 1) - along.z * along, perpendicular(along));
    return glm::quat_cast(glm::mat3(glm::cross(along, up), -up, along));
}

LeafAttachment attachmentAt(const glm::vec3& anchor, const glm::vec3& tangent, float around) {
    const glm::vec3 e1 = perpendicular(tangent);
    return {anchor, tangent, math::cos(around) * e1 + math::sin(around) * glm::cross(tangent, e1)};
}

/// @param along position on the unit, 0 to 1.
LeafAttachment attachmentOn(const Skeleton& skeleton, std::size_t unit, float along, float around) {
    const float place = along * static_cast<float>(skeleton.ringsPerBranch - 1);
    const int ring = std::min(static_cast<int>(place), skeleton.ringsPerBranch - 2);
    return attachmentAt(glm::mix(skeleton.point(unit, ring), skeleton.point(unit, ring + 1),
                                 place - static_cast<float>(ring)),
                        skeleton.tangent(unit, ring), around);
}

/// @param left metres along the shoot.
LeafAttachment attachmentOn(const Skeleton& skeleton, const Shoot& shoot, float left, float around) {
    for (std::size_t i = 1;; ++i) {
        const glm::vec3 from = skeleton.shootPoint(shoot, i - 1), way = skeleton.shootPoint(shoot, i) - from;
        const float length = glm::length(way);
        if (left <= length || i + 1 == shoot.count)
            return attachmentAt(from + way * (length > 0.0f ? std::min(left / length, 1.0f) : 0.0f),
                                directionOr(way, up), around);
        left -= length;
    }
}

/// @param onward component along the branch.
glm::vec3 petioleOf(const LeafAttachment& attachment, float onward, float droop) {
    return directionOr(attachment.outward + onward * attachment.tangent - glm::vec3(0, 0, droop * 1.2f),
                       attachment.outward);
}

/// Spaces clusters evenly over all leafy stretches.
std::vector<LeafCluster> spreadClusters(const Skeleton& skeleton, const LeafParameters& p) {
    const std::vector<Stretch> stretches = leafyStretches(skeleton, p);
    float whole = 0.0f;
    for (const Stretch& stretch : stretches)
        whole += stretch.share();
    std::vector<LeafCluster> clusters;
    if (!(whole > 0.0f))
        return clusters;
    clusters.reserve(static_cast<std::size_t>(p.clusters));
    const float spacing = whole / static_cast<float>(p.clusters);
    Random random(p.seed), angles(p.seed ^ 0x5eafull << 32);
    float passed = 0.0f;
    for (const Stretch& stretch : stretches) {
        passed += stretch.share();
        const float start = random.uniform() * glm::two_pi<float>();
        for (int i = 0; static_cast<float>(clusters.size()) * spacing < passed - 0.5f * spacing; ++i) {
            const float left = passed - (static_cast<float>(clusters.size()) + 0.5f) * spacing;
            const float t = glm::clamp((stretch.to - left / stretch.weight) / stretch.length, 0.0f, 1.0f);
            const float around = start + goldenAngle * static_cast<float>(i) + 0.5f * random.symmetric();
            const LeafAttachment attachment =
                stretch.shoot ? attachmentOn(skeleton, *stretch.shoot, t * stretch.length, around)
                              : attachmentOn(skeleton, stretch.unit, t, around);
            const glm::vec3 petiole = petioleOf(attachment, 0.8f, p.droop);

            LeafCluster cluster;
            cluster.anchor = attachment.anchor;
            cluster.unit = static_cast<int>(stretch.unit);
            const float turn = random.symmetric() * glm::pi<float>();
            cluster.orientation =
                p.frond ? frondFrame(attachment.tangent)
                : p.inclination > 0.0f
                    ? sprayFrame(attachment, petiole, leafAngle(angles, clusterShare * p.inclination),
                                 leanSpread * turn)
                    : leafFrame(petiole, turn);
            cluster.size = 1.0f + 0.25f * random.symmetric();
            clusters.push_back(cluster);
        }
    }
    return clusters;
}

/// One quad: its start over the petiole's length, and its axes across and along.
struct QuadPlace {
    float start;
    glm::vec3 side, along;
};

/// A quad of a fan about the petiole; it leans away from the petiole, so that the cluster fills a volume.
QuadPlace fanQuad(int quad) {
    const float turn = glm::two_pi<float>() * static_cast<float>(quad) / quadsPerLeafCluster;
    const glm::vec3 away{-math::sin(turn), math::cos(turn), 0.0f};
    return {0.0f,
            {math::cos(turn), math::sin(turn), 0.0f},
            math::cos(0.5f) * glm::vec3(0, 0, 1) + math::sin(0.5f) * away};
}

/// A quad of a flat spray: the first continues the petiole from further out, the others point to both sides,
/// a little out of the plane; each is rotated about its length.
QuadPlace sprayQuad(int quad) {
    const float roll = leafFold * (quad == 0 ? 0.5f : quad == 1 ? 1.0f : -1.0f);
    if (quad == 0)
        return {0.4f, {math::cos(roll), math::sin(roll), 0}, {0, 0, 1}};
    const float turn = quad == 1 ? 1.05f : -1.05f;
    const glm::vec3 ahead{math::sin(turn), 0.0f, math::cos(turn)},
        across{math::cos(turn), 0.0f, -math::sin(turn)};
    const glm::vec3 along = math::cos(0.1f) * ahead + math::sin(0.1f) * glm::vec3(0, 1, 0);
    return {0.0f, math::cos(roll) * across + math::sin(roll) * glm::cross(along, across), along};
}

/// Shoots of a twig: two hang at its sides, the third lies on top.
void addHangingQuad(const LeafParameters& parameters, int quad, LeafVertex* corners) {
    const float hand = quad == 0 ? 1.0f : -1.0f;
    const float steep = (quad == 2 ? lyingShare : hangingShare) * parameters.inclination;
    const glm::vec3 aside{hand * math::cos(steep), math::sin(steep), 0.0f}, ahead{0.0f, 0.0f, 1.0f};
    const glm::vec3 along = quad == 2 ? ahead : math::cos(onward) * aside + math::sin(onward) * ahead;
    const glm::vec3 side =
        quad == 2 ? -aside : hand * (math::sin(onward) * aside - math::cos(onward) * ahead);
    const float start = quad == 0 ? 0.25f : quad == 1 ? 0.6f : 0.0f;
    const glm::vec3 normal = glm::cross(side, along);
    for (int corner = 0; corner < 4; ++corner) {
        const glm::vec2 uv{corner == 1 || corner == 2 ? 1.0f : 0.0f, corner >= 2 ? 1.0f : 0.0f};
        corners[corner] = {start * parameters.length * ahead +
                               (uv.x - 0.5f) * hangingWidth * parameters.width * side +
                               uv.y / hangingWidth * parameters.length * along,
                           normal, uv};
    }
}

/// A row of leaflets along a segment of a frond: to the right and left in a V, or hanging.
void addFrondRow(const LeafParameters& parameters, int row, LeafVertex* corners) {
    const float lean = row == 0 ? rowAngle : row == 1 ? -rowAngle : 2.9f; // from the upright
    const glm::vec3 outward{math::sin(lean), -math::cos(lean), 0.0f};
    const float upward = row == 1 ? 1.0f : -1.0f;
    const glm::vec3 normal{upward * math::cos(lean), upward * math::sin(lean), 0.0f};
    for (int corner = 0; corner < 4; ++corner) {
        const glm::vec2 uv{corner == 1 || corner == 2 ? 1.0f : 0.0f, corner >= 2 ? 1.0f : 0.0f};
        corners[corner] = {uv.x * parameters.length * glm::vec3(0, 0, 1) + uv.y * parameters.width * outward,
                           normal, uv};
    }
}

} // namespace

LeafParameters clamped(LeafParameters parameters) {
    return clampedKeys(parameters);
}

std::vector<LeafCluster> makeLeafClusters(const Skeleton& skeleton, const LeafParameters& wanted) {
    const LeafParameters parameters = clamped(wanted);
    if (parameters.clusters > 0)
        return spreadClusters(skeleton, parameters);
    const int lastLevel = lastLevelOf(skeleton);
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
            const float around = start + goldenAngle * static_cast<float>(i) + 0.5f * random.symmetric();
            const LeafAttachment attachment = attachmentOn(skeleton, index, t, around);
            const glm::vec3 petiole = petioleOf(attachment, 0.35f + 0.45f * t, parameters.droop);

            LeafCluster cluster;
            cluster.anchor = attachment.anchor;
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
        if (parameters.frond) {
            addFrondRow(parameters, quad, &mesh[static_cast<std::size_t>(4 * quad)]);
            continue;
        }
        if (parameters.hanging && parameters.inclination > 0.0f) {
            addHangingQuad(parameters, quad, &mesh[static_cast<std::size_t>(4 * quad)]);
            continue;
        }
        const auto [start, side, along] = parameters.inclination > 0.0f ? sprayQuad(quad) : fanQuad(quad);
        const glm::vec3 normal = glm::cross(side, along);
        for (int corner = 0; corner < 4; ++corner) {
            const glm::vec2 uv{corner == 1 || corner == 2 ? 1.0f : 0.0f, corner >= 2 ? 1.0f : 0.0f};
            mesh[static_cast<std::size_t>(4 * quad + corner)] = {
                side * (2.0f * uv.x - 1.0f) * half + along * (start + uv.y) * parameters.length, normal, uv};
        }
    }
    return mesh;
}

} // namespace osgTreeWind
