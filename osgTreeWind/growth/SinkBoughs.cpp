// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/SinkBoughs.h>

#include <osgTreeWind/base/UnitVectors.h>

#include <cmath>

namespace osgTreeWind {
namespace {

/// Lowest height of branches above the ground, metres.
constexpr float minShootHeight = 0.35f;
/// Years in which a bough does half of its sinking.
constexpr float sinkingYears = 12.0f;

/// Share of its lean that a stem loses as it thickens, if `rise` is 1.
constexpr float straightening = 0.6f;

/// `heading` rotated downwards by a small angle, short of the vertical.
glm::vec3 tiltDown(const glm::vec3& heading, float angle) {
    const float across = std::sqrt(heading.x * heading.x + heading.y * heading.y);
    if (across < 0.05f && heading.z < 0.0f)
        return heading;
    const float cosine = 1.0f - 0.5f * angle * angle, sine = angle - angle * angle * angle / 6.0f;
    const float goal = std::max(across * cosine + heading.z * sine, 0.02f);
    const float z = heading.z * cosine - across * sine;
    const glm::vec3 aside =
        across > 1e-4f ? glm::vec3(heading.x, heading.y, 0.0f) / across : glm::vec3(1, 0, 0);
    return directionOr(goal * aside + z * up, heading);
}

} // namespace

void placeNodes(TreeState& tree) {
    for (std::size_t i = 1; i < tree.metamers.size(); ++i) {
        Metamer& metamer = tree.metamers[i];
        const glm::vec3& from = tree.metamers[static_cast<std::size_t>(metamer.parent)].position;
        metamer.position = from + metamer.length * metamer.heading;
        if (metamer.order == 0 || metamer.position.z >= minShootHeight)
            continue;
        metamer.heading = directionOr({metamer.heading.x, metamer.heading.y, 0.1f}, metamer.heading);
        metamer.position = from + metamer.length * metamer.heading;
    }
}

void sinkBoughs(TreeState& tree) {
    const TreeHabit& habit = tree.habit;
    for (std::size_t i = 1; i < tree.metamers.size(); ++i) {
        Metamer& metamer = tree.metamers[i];
        metamer.tilt = 0.0f;
        const Metamer& parent = tree.metamers[static_cast<std::size_t>(metamer.parent)];
        const float age = static_cast<float>(tree.year - metamer.born) / sinkingYears;
        const float yearly = 1.0f / (sinkingYears * (1.0f + age) * (1.0f + age));
        if (metamer.order == 0) {
            // A nodding leader straightens as it thickens.
            const float pull = habit.hang[0] > 0.0f && tree.year - metamer.born >= 2
                                   ? 0.8f
                                   : straightening * yearly * std::max(habit.rise[0], 0.0f);
            metamer.heading =
                directionOr(metamer.heading + pull * tree.stemDirection(metamer.position.z), up);
            continue;
        }
        const std::size_t rank = TreeState::rank(metamer.order);
        const float level = std::sqrt(std::max(1.0f - metamer.heading.z * metamer.heading.z, 0.0f));
        const ShootAxis& axis = tree.axes[static_cast<std::size_t>(metamer.axis)];
        float bend = axis.leading ? 0.0f : habit.hang[rank] * metamer.length * level;
        if (metamer.axis != parent.axis && !axis.leading)
            bend += habit.sink[rank] * axis.vigourFactor;
        const float free = std::clamp(0.5f * (metamer.position.z - minShootHeight), 0.0f, 1.0f);
        metamer.tilt = free * std::clamp(parent.tilt + yearly * bend, -0.5f, 0.5f);
        metamer.heading = tiltDown(metamer.heading, metamer.tilt);
    }
    for (Bud& bud : tree.buds) {
        const Metamer& metamer = tree.metamers[static_cast<std::size_t>(bud.node)];
        bud.heading = bud.terminal && bud.node > 0 ? metamer.heading : tiltDown(bud.heading, metamer.tilt);
    }
    placeNodes(tree);
}

} // namespace osgTreeWind
