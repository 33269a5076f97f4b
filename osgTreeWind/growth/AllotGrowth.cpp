// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/AllotGrowth.h>

#include <glm/common.hpp>

namespace osgTreeWind {
namespace {

/// Sets the gains of all buds and sums them towards the foot.
void sumGains(TreeState& tree) {
    for (Metamer& metamer : tree.metamers)
        metamer.mainGain = metamer.sideGain = 0.0f;
    const float need = tree.lightNeed();
    for (Bud& bud : tree.buds) {
        bud.gain = bud.weight * std::max(bud.light - need, 0.0f) / (1.0f - need);
        Metamer& metamer = tree.metamers[static_cast<std::size_t>(bud.node)];
        (bud.terminal ? metamer.mainGain : metamer.sideGain) += bud.gain;
    }
    for (std::size_t i = tree.metamers.size() - 1; i > 0; --i) {
        const Metamer& metamer = tree.metamers[i];
        Metamer& parent = tree.metamers[static_cast<std::size_t>(metamer.parent)];
        (metamer.axis == parent.axis ? parent.mainGain : parent.sideGain) +=
            metamer.mainGain + metamer.sideGain;
    }
}

} // namespace

void allotGrowth(TreeState& tree) {
    sumGains(tree);
    std::vector<float> perMain(tree.metamers.size()), perSide(tree.metamers.size());
    for (std::size_t i = 0; i < tree.metamers.size(); ++i) {
        Metamer& metamer = tree.metamers[i];
        if (i == 0) {
            metamer.share = metamer.mainGain + metamer.sideGain;
        } else {
            const auto parent = static_cast<std::size_t>(metamer.parent);
            const bool goesOn = metamer.axis == tree.metamers[parent].axis;
            metamer.share =
                (goesOn ? perMain[parent] : perSide[parent]) * (metamer.mainGain + metamer.sideGain);
        }
        float control = tree.habit.apicalControl[TreeState::rank(metamer.order)];
        if (metamer.order == 0)
            control = glm::mix(control, tree.habit.apicalControlOld, tree.relativeHeight());
        const float sum = control * metamer.mainGain + (1.0f - control) * metamer.sideGain;
        if (sum > 0.0f) {
            perMain[i] = metamer.share * control / sum;
            perSide[i] = metamer.share * (1.0f - control) / sum;
        }
    }
    for (Bud& bud : tree.buds) {
        const auto node = static_cast<std::size_t>(bud.node);
        bud.share = (bud.terminal ? perMain[node] : perSide[node]) * bud.gain;
    }
}

} // namespace osgTreeWind
