// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/LeafOutlines.h>

#include <glm/common.hpp>

namespace osgTreeWind {
namespace {

/// One step of corner cutting (Chaikin 1974).
LeafOutline rounded(const LeafOutline& outline) {
    LeafOutline round{outline.front()};
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
        round.push_back(glm::mix(outline[i], outline[i + 1], 0.25f));
        round.push_back(glm::mix(outline[i], outline[i + 1], 0.75f));
    }
    round.push_back(outline.back());
    return round;
}

/// Small ears at the foot, widest above the middle.
constexpr glm::vec2 lobed[] = {{0.02f, 0.0f},  {0.09f, 0.02f}, {0.10f, 0.08f}, {0.06f, 0.13f}, {0.20f, 0.23f},
                               {0.20f, 0.30f}, {0.09f, 0.32f}, {0.27f, 0.44f}, {0.28f, 0.52f}, {0.12f, 0.52f},
                               {0.34f, 0.66f}, {0.34f, 0.75f}, {0.16f, 0.73f}, {0.26f, 0.86f}, {0.23f, 0.94f},
                               {0.11f, 0.90f}, {0.10f, 1.0f},  {0.0f, 1.0f}};
/// Three toothed lobes on each side, the middle one longest, and one at the tip.
constexpr glm::vec2 pointed[] = {
    {0.02f, 0.0f},  {0.06f, 0.09f}, {0.20f, 0.17f}, {0.12f, 0.23f}, {0.09f, 0.29f}, {0.24f, 0.34f},
    {0.34f, 0.43f}, {0.22f, 0.45f}, {0.10f, 0.46f}, {0.24f, 0.55f}, {0.38f, 0.62f}, {0.28f, 0.66f},
    {0.32f, 0.74f}, {0.19f, 0.70f}, {0.10f, 0.68f}, {0.18f, 0.79f}, {0.23f, 0.89f}, {0.12f, 0.86f},
    {0.06f, 0.84f}, {0.06f, 0.93f}, {0.0f, 1.0f}};
/// Short point, wavy edge.
constexpr glm::vec2 ovate[] = {{0.0f, 0.0f},   {0.17f, 0.05f}, {0.31f, 0.22f}, {0.34f, 0.42f},
                               {0.29f, 0.62f}, {0.19f, 0.80f}, {0.08f, 0.93f}, {0.0f, 1.0f}};
/// Straight wedge below, double teeth to a long point.
constexpr glm::vec2 rhombic[] = {{0.0f, 0.0f},   {0.20f, 0.12f}, {0.38f, 0.28f}, {0.33f, 0.36f},
                                 {0.37f, 0.42f}, {0.27f, 0.51f}, {0.28f, 0.57f}, {0.19f, 0.64f},
                                 {0.19f, 0.70f}, {0.10f, 0.78f}, {0.05f, 0.90f}, {0.0f, 1.0f}};
/// Five lobes, the outer ones at right angles.
constexpr glm::vec2 palmate[] = {{0.0f, 0.12f},  {0.14f, 0.02f}, {0.26f, 0.04f}, {0.38f, 0.0f},
                                 {0.37f, 0.12f}, {0.44f, 0.22f}, {0.33f, 0.30f}, {0.45f, 0.42f},
                                 {0.47f, 0.54f}, {0.60f, 0.62f}, {0.50f, 0.66f}, {0.48f, 0.73f},
                                 {0.35f, 0.63f}, {0.20f, 0.56f}, {0.24f, 0.72f}, {0.17f, 0.76f},
                                 {0.16f, 0.87f}, {0.07f, 0.89f}, {0.0f, 1.0f}};
/// A leaflet.
constexpr glm::vec2 pinnate[] = {{0.0f, 0.0f},   {0.10f, 0.08f}, {0.18f, 0.28f},
                                 {0.18f, 0.46f}, {0.12f, 0.72f}, {0.0f, 1.0f}};
constexpr glm::vec2 heart[] = {{0.0f, 0.10f},  {0.08f, 0.0f},  {0.26f, -0.03f},
                               {0.43f, 0.12f}, {0.46f, 0.36f}, {0.36f, 0.62f},
                               {0.17f, 0.82f}, {0.06f, 0.90f}, {0.0f, 1.0f}};
constexpr glm::vec2 round[] = {{0.0f, 0.0f},   {0.30f, 0.0f},  {0.52f, 0.22f}, {0.55f, 0.52f},
                               {0.40f, 0.82f}, {0.12f, 0.93f}, {0.0f, 1.0f}};
/// A leaflet, widest near its end.
constexpr glm::vec2 fingered[] = {{0.0f, 0.0f},   {0.05f, 0.15f}, {0.13f, 0.42f}, {0.21f, 0.66f},
                                  {0.20f, 0.80f}, {0.09f, 0.90f}, {0.0f, 1.0f}};
/// Notched in the middle.
constexpr glm::vec2 fan[] = {{0.0f, 0.0f},   {0.12f, 0.22f}, {0.55f, 0.52f}, {0.66f, 0.66f}, {0.50f, 0.82f},
                             {0.32f, 0.94f}, {0.12f, 1.0f},  {0.03f, 0.96f}, {0.0f, 0.70f}};
constexpr glm::vec2 needles[] = {{0.05f, 0.0f}, {0.05f, 0.8f}, {0.0f, 1.0f}};
constexpr glm::vec2 tufts[] = {{0.035f, 0.0f}, {0.035f, 0.85f}, {0.0f, 1.0f}};
constexpr glm::vec2 bundles[] = {{0.02f, 0.0f}, {0.02f, 0.9f}, {0.0f, 1.0f}};
constexpr glm::vec2 frond[] = {{0.012f, 0.0f}, {0.03f, 0.3f}, {0.02f, 0.75f}, {0.0f, 1.0f}};
constexpr glm::vec2 blade[] = {{0.0f, 0.0f},   {0.12f, 0.10f}, {0.24f, 0.34f},
                               {0.22f, 0.60f}, {0.10f, 0.84f}, {0.0f, 1.0f}};

template <std::size_t count>
LeafOutline outline(const glm::vec2 (&points)[count]) {
    return {points, points + count};
}

} // namespace

LeafOutline leafOutline(LeafForm form) {
    switch (form) {
    case LeafForm::Lobed:
        return rounded(outline(lobed));
    case LeafForm::Ovate:
        return rounded(outline(ovate));
    case LeafForm::Rhombic:
        return outline(rhombic);
    case LeafForm::Palmate:
        return outline(palmate);
    case LeafForm::Pinnate:
        return rounded(outline(pinnate));
    case LeafForm::Heart:
        return rounded(outline(heart));
    case LeafForm::Round:
        return rounded(outline(round));
    case LeafForm::Fingered:
        return rounded(outline(fingered));
    case LeafForm::Fan:
        return rounded(outline(fan));
    case LeafForm::Needles:
    case LeafForm::Combed:
        return outline(needles);
    case LeafForm::Tufts:
        return outline(tufts);
    case LeafForm::Bundles:
        return outline(bundles);
    case LeafForm::Frond:
        return outline(frond);
    case LeafForm::Pointed:
        return outline(pointed);
    case LeafForm::Blade:
        break;
    }
    return rounded(outline(blade));
}

} // namespace osgTreeWind
