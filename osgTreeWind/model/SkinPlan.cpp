// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/SkinPlan.h>

#include <osgTreeWind/model/StemFoot.h>

namespace osgTreeWind {
namespace {

constexpr float stout = 0.012f; ///< Radius of branches from which on a collar has a ring of its own, metres.

int sidesFor(float radius) {
    return radius >= 0.12f ? 20 : radius >= 0.05f ? 10 : radius >= 0.02f ? 8 : 6;
}

} // namespace

std::vector<SkinPlan> planSkin(const Skeleton& skeleton, const SkinDetail& detail) {
    const bool whole = !detail.sides;
    std::vector<SkinPlan> plans;
    plans.reserve(skeleton.units.size());
    for (const BranchUnit& unit : skeleton.units) {
        const bool stem = unit.parent < 0;
        SkinPlan plan{detail.rings, detail.sides.value_or(sidesFor(unit.baseRadius)),
                      !stem && unit.attach >= 1.0f, whole};
        if (plan.fromEnd) {
            SkinPlan& parent = plans[static_cast<std::size_t>(unit.parent)];
            parent.closed = false;
            int sides = parent.sides;
            while (sides % 4 == 0 && sides / 2 >= plan.sides)
                sides /= 2;
            plan.sides = sides;
        } else if (whole && stem && StemFoot(skeleton).height() > 0.0f) {
            plan.rings += static_cast<int>(StemFoot::rings.size());
        } else if (whole && !stem && unit.baseRadius >= stout) {
            ++plan.rings;
        }
        plans.push_back(plan);
    }
    return plans;
}

} // namespace osgTreeWind
