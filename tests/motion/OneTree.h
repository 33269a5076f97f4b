// SPDX-License-Identifier: MIT
#pragma once

#include <tests/motion/Sapling.h>

#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <cstring>
#include <functional>

namespace osgTreeWind {

/// A wind defined by a function.
class TestWind : public WindField {
public:
    explicit TestWind(std::function<glm::vec3(const glm::vec3&, double)> f) : _f(std::move(f)) {}
    glm::vec3 velocity(const WindPlace& place, double time) const override {
        return _f(place.position, time);
    }

private:
    std::function<glm::vec3(const glm::vec3&, double)> _f;
};

inline WindFieldPtr uniform(const glm::vec3& v) {
    return std::make_shared<TestWind>([v](const glm::vec3&, double) { return v; });
}

/// One sapling at the origin.
inline ForestDescription oneTree(MotionLaw law = MotionLaw::Thesis) {
    ForestDescription forest;
    forest.species = {sapling()};
    forest.trees.resize(1);
    forest.law = law;
    return forest;
}

inline void run(ForestSimulation& simulation, int frames, double start = 0.0, double step = 1.0 / 60.0) {
    for (int i = 0; i <= frames; ++i)
        simulation.advance(start + i * step);
}

/// Tip of a unit, tree frame.
inline glm::vec3 tip(const ForestSimulation& simulation, std::size_t unit) {
    const PlacedTree& tree = movingForest(simulation).trees()[0];
    const BranchUnit& branch = movingForest(simulation).models()[tree.model]->skeleton.units[unit];
    return movingForest(simulation).motion(0).poses[unit].apply(tree.scale.axes * branch.tip);
}

template <typename T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

} // namespace osgTreeWind
