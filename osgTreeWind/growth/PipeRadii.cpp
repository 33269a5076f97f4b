// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/PipeRadii.h>

#include <osgTreeWind/base/PortableMath.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

constexpr float stemTaper = 0.6f;
constexpr float maxBranchRatio = 0.88f;
/// Lower limit of the radius of the trunk's top / at breast height.
constexpr float minTopRatio = 1e-3f;

/// Number of shoot tips that each metamer bears.
std::vector<int> countTips(const std::vector<GrownMetamer>& metamers) {
    std::vector<int> ends(metamers.size(), 0);
    for (std::size_t i = metamers.size(); i-- > 0;) {
        ends[i] = std::max(ends[i], 1);
        if (metamers[i].parent >= 0)
            ends[static_cast<std::size_t>(metamers[i].parent)] += ends[i];
    }
    return ends;
}

float naturalLog(float x) {
    return static_cast<float>(std::log(static_cast<double>(x)));
}

/// Radius of wood from the number of its shoot tips. Boughs together have about the cross-section of the
/// trunk (Leonardo's rule); twigs taper faster, to the radius of the thinnest.
class PipeModel {
public:
    PipeModel(float trunk, float twig, int ends)
        : _trunk(trunk), _logEnds(naturalLog(static_cast<float>(ends))),
          _thinning(std::min(naturalLog(twig / trunk) + area * _logEnds, 0.4f * area * _logEnds)) {}

    float radius(int ends) const {
        const float share = naturalLog(static_cast<float>(ends)) / _logEnds, thin = 1.0f - share;
        return _trunk *
               static_cast<float>(std::exp(static_cast<double>(thin * (thin * _thinning - area * _logEnds))));
    }

private:
    static constexpr float area = 0.46f;
    float _trunk, _logEnds, _thinning;
};

} // namespace

void setRadii(GrownForm& form, const GrowthGoal& goal, float twigRadius) {
    std::vector<GrownMetamer>& metamers = form.metamers;
    const std::vector<int> ends = countTips(metamers);
    const float breast = std::min(1.3f, 0.1f * goal.height), atBreast = 0.5f * goal.trunkDiameter;
    const float twig = std::min(twigRadius, 0.2f * atBreast);
    const PipeModel pipes(atBreast, twig, std::max(ends[0], 3));
    float trunkTop = 0.0f;
    for (const GrownMetamer& metamer : metamers)
        if (metamer.axis == 0)
            trunkTop = std::max(trunkTop, metamer.position.z);
    const bool dissolves = trunkTop < 0.93f * goal.height;
    std::vector<float> factor(metamers.size(), 1.0f);
    for (std::size_t i = 0; i < metamers.size(); ++i) {
        GrownMetamer& metamer = metamers[i];
        const float pipe = pipes.radius(ends[i]);
        const auto parent = static_cast<std::size_t>(std::max(metamer.parent, 0));
        if (metamer.axis == 0) {
            const float above = std::max(goal.height - metamer.position.z, 0.0f) / (goal.height - breast);
            metamer.radius = std::max(atBreast * power(above, stemTaper), minTopRatio * atBreast);
            metamer.radius = std::max(metamer.radius, 0.8f * twig);
            if (dissolves) {
                // Where limbs branch off, the rest of the trunk follows the pipe model.
                const float along =
                    std::max(metamer.position.z - breast, 0.0f) / std::max(trunkTop - breast, 0.01f);
                metamer.radius += std::min(along * along, 1.0f) * std::min(pipe - metamer.radius, 0.0f);
            }
            if (i > 0)
                metamer.radius = std::min(metamer.radius, metamers[parent].radius);
            continue;
        }
        const float parentRadius = metamers[parent].radius;
        const bool first = metamers[parent].axis != metamer.axis;
        factor[i] = first ? std::min(1.0f, maxBranchRatio * parentRadius / pipe) : factor[parent];
        metamer.radius = std::min(pipe * factor[i], parentRadius);
    }
}

} // namespace osgTreeWind
