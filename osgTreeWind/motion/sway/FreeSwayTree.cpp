// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/sway/FreeSwayTree.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/modal/ModalPoses.h>
#include <osgTreeWind/species/ShapeCount.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t halfSwings = 6;
constexpr double stepsPerSwing = 60.0; // to and fro
constexpr double maxDuration = 600.0;  // seconds

/// Measures frequency and damping ratio of an oscillation about 0, from its first zero crossing on.
class SwingMeter {
public:
    explicit SwingMeter(double start) : _before(start) {}

    void add(double now, double time, double step) {
        if (done())
            return;
        if ((_before > 0.0) != (now > 0.0)) {
            if (!_crossings.empty())
                _peaks.push_back(_peak);
            _crossings.push_back(time - step * now / (now - _before));
            _peak = 0.0;
        }
        _peak = std::max(_peak, std::abs(now));
        _before = now;
    }

    bool done() const { return _crossings.size() > halfSwings; }
    double frequency() const {
        return 0.5 * static_cast<double>(halfSwings) / (_crossings.back() - _crossings.front());
    }
    /// From the logarithmic decrement of the peaks.
    double dampingRatio() const {
        const double decrement =
            math::log(_peaks.front() / _peaks.back()) / static_cast<double>(_peaks.size() - 1);
        return decrement / math::hypot(glm::pi<double>(), decrement);
    }

private:
    std::vector<double> _crossings, _peaks;
    double _before, _peak = 0.0;
};

/// The species with only the shape that trees of a seed have, so that no other shape is grown.
Species withSingleShape(Species species, std::uint32_t seed) {
    if (species.tree.scans) // scans are not grown
        return species;
    const std::uint32_t variant = seed % shapeCount(species);
    species.shapes = 1;
    species.tree.wood.seed += variant;
    species.tree.leaves.seed += variant;
    if (species.tree.palm)
        species.tree.palm->seed += variant;
    if (species.tree.growth)
        species.tree.growth->seed += variant;
    return species;
}

} // namespace

PlacedForest makeSingleTreeForest(const Species& species, const TreePlacement& tree) {
    ForestDescription forest;
    forest.species = {withSingleShape(species, tree.seed)};
    forest.trees = {tree};
    forest.trees[0].species = 0;
    forest.trees[0].position = glm::dvec3(0.0);
    forest.trees[0].heading = 0.0f;
    return PlacedForest(std::move(forest));
}

FreeSwayTree::FreeSwayTree(const Species& species, const TreePlacement& tree)
    : _forest(makeSingleTreeForest(species, tree)),
      _motion({makeModalTree(_forest, _forest.trees.front())}, 1.0f, {}, true) {
    const PlacedTree& placed = _forest.trees.front();
    const std::vector<BranchUnit>& units = _forest.modelOf(placed).skeleton.units;
    for (std::size_t i = 0; i < units.size(); ++i) {
        _rest.push_back(placed.scale.axes * units[i].tip);
        if (units[i].level == 0)
            _top = i;
    }
}

double FreeSwayTree::omega(std::size_t mode) const {
    const ModalModel::Mode& m = modes()[mode];
    return static_cast<double>(m.omega) * std::sqrt(static_cast<double>(Laws().weightLeaves(m.weightShare)));
}

void FreeSwayTree::step(double seconds) {
    _time += seconds;
    _motion.step(nullptr, _time, static_cast<float>(seconds));
}

std::vector<glm::vec3> FreeSwayTree::tipDisplacements() {
    const std::vector<UnitPose> poses = modalPoses(_forest, 0, _motion, _motion.poseVector(0));
    std::vector<glm::vec3> shifts(_rest.size());
    for (std::size_t i = 0; i < _rest.size(); ++i)
        shifts[i] = poses[i].apply(_rest[i]) - _rest[i];
    return shifts;
}

std::vector<std::vector<glm::vec3>> FreeSwayTree::tipDisplacementsByMode() {
    constexpr float part = 1e-3f; // of the limit, which is about ten times the largest angle
    std::vector<std::vector<glm::vec3>> byMode;
    for (std::size_t k = 0; k < modes().size(); ++k) {
        std::vector<float> amplitudes(modes().size(), 0.0f);
        amplitudes[k] = part * modes()[k].limit;
        setAmplitudes(amplitudes);
        byMode.push_back(tipDisplacements());
        for (glm::vec3& shift : byMode.back())
            shift /= amplitudes[k];
    }
    setAmplitudes({});
    return byMode;
}

std::optional<FreeSway> FreeSwayTree::measureFreeSway(std::size_t mode,
                                                      const std::function<double()>& followed) {
    const double h = glm::two_pi<double>() / omega(mode) / stepsPerSwing;
    SwingMeter all(followed()), own(static_cast<double>(amplitude(mode)));
    for (double time = h; time < maxDuration && !(all.done() && own.done()); time += h) {
        step(h);
        all.add(followed(), time, h);
        own.add(static_cast<double>(amplitude(mode)), time, h);
    }
    if (!all.done() || !own.done())
        return {};
    return FreeSway{all.frequency(), own.dampingRatio()};
}

} // namespace osgTreeWind
