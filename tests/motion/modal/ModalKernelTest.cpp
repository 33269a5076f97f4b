// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalKernel.h>

#include <osgTreeWind/base/Random.h>

#include <tests/EnvironmentVariable.h>
#include <tests/motion/GrownTree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

namespace osgTreeWind {

void stepTreesPlain(const ModalStep& step); // PlainKernel.cpp

namespace {

using Limits = std::numeric_limits<float>;
constexpr std::size_t lanes = TreeLanes::count;

ModalModel modelOf(const char* species, const TreeSize& size, float dampingRatio = 0.05f) {
    const GrownTree tree(species, size);
    ModalMaterial material = tree.material();
    material.dampingRatio = dampingRatio;
    return makeModalModel(tree.joints(), material);
}

const ModalModel& oak() {
    static const ModalModel model = modelOf("oak", {18, 0.3f, 0});
    return model;
}

/// The model without drag and without damping by wood.
ModalModel withoutDamping(ModalModel model) {
    model.dampingRatio = 0.0f;
    for (ModalModel::Patch& patch : model.patches)
        patch.woodDrag = patch.leafDrag = patch.stillDrag = 0.0f;
    return model;
}

/// Eight trees of one model.
class Block {
public:
    explicit Block(const ModalModel& model)
        : _model(&model), _numbers(treeFloats(model)), _wind(3 * model.patches.size()) {
        for (std::size_t tree = 0; tree < lanes; ++tree)
            setFactors(tree, TreeFactors());
    }

    void setFactors(std::size_t tree, const TreeFactors& factors) {
        float numbers[sizeof factors / sizeof(float)];
        std::memcpy(numbers, &factors, sizeof factors);
        for (std::size_t i = 0; i < std::size(numbers); ++i)
            _numbers[_numbers.size() - std::size(numbers) + i].tree[tree] = numbers[i];
    }
    std::size_t modes() const { return _model->modes.size(); }
    float& amplitude(std::size_t mode, std::size_t tree) { return _numbers[mode].tree[tree]; }
    float& speed(std::size_t mode, std::size_t tree) { return _numbers[modes() + mode].tree[tree]; }

    /// Sets the same wind at all patches of a tree from the next step on.
    void setWind(std::size_t tree, const glm::vec3& wind) {
        for (std::size_t i = 0; i < _wind.size(); ++i)
            _wind[i].tree[tree] = wind[static_cast<glm::length_t>(i % 3)];
    }
    void step(float seconds, int substeps = 1, InstructionSet set = bestInstructionSet()) {
        step(seconds, substeps, [set](const ModalStep& step) { stepTrees(step, set); });
    }
    void step(float seconds, int substeps, const std::function<void(const ModalStep&)>& kernel) {
        ModalStep step;
        step.model = _model;
        step.block = _numbers.data();
        step.wind = _wind.data();
        step.seconds = seconds;
        step.substeps = substeps;
        kernel(step);
    }

    /// Amplitudes, speeds and winds of a tree.
    std::vector<float> state(std::size_t tree) const {
        std::vector<float> numbers;
        for (std::size_t i = 0; i < 2 * modes() + _wind.size(); ++i)
            numbers.push_back(_numbers[i].tree[tree]);
        return numbers;
    }
    double energy(std::size_t tree) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < modes(); ++k) {
            const double left =
                1.0 - std::clamp(static_cast<double>(_model->modes[k].weightShare), -1.0, 0.75);
            const double omega = _model->modes[k].omega, angle = _numbers[k].tree[tree],
                         speed = _numbers[modes() + k].tree[tree];
            sum += 0.5 * (omega * omega * left * angle * angle + speed * speed);
        }
        return sum;
    }
    /// Joint angles without the static residual of the air.
    float largestAngle(std::size_t tree) const {
        float most = 0.0f;
        for (std::size_t i = 0; i < _model->joints; ++i) {
            float angle = 0.0f;
            for (std::size_t k = 0; k < modes(); ++k)
                angle += _model->poses[i * _model->columns() + k] * _numbers[k].tree[tree];
            most = std::max(most, std::abs(angle));
        }
        return most;
    }
    testing::AssertionResult sound(std::size_t tree) const {
        const std::vector<float> numbers = state(tree);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (!std::isfinite(numbers[i]))
                return testing::AssertionFailure() << "number " << i << " is " << numbers[i];
        for (std::size_t k = 0; k < modes(); ++k)
            if (std::abs(numbers[k]) > _model->modes[k].limit)
                return testing::AssertionFailure()
                       << "mode " << k << " at " << numbers[k] << " beyond " << _model->modes[k].limit;
        return testing::AssertionSuccess();
    }

private:
    const ModalModel* _model;
    std::vector<TreeLanes> _numbers, _wind;
};

/// From 1e-5 to 0.1 s, log-uniform.
float anyStep(Random& random) {
    return 1e-5f * std::pow(1e4f, random.uniform());
}

/// Up to a speed, in any direction.
glm::vec3 anyWind(Random& random, float speed) {
    return speed * random.uniform() *
           glm::vec3(random.symmetric(), random.symmetric(), 0.3f * random.symmetric());
}

std::vector<InstructionSet> instructionSets() {
    std::vector<InstructionSet> sets;
    for (const InstructionSet set : {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512})
        if (set <= bestInstructionSet())
            sets.push_back(set);
    return sets;
}

/// A block whose modes have random amplitudes and speeds up to a hundredth of their limit.
Block movingBlock(const ModalModel& model) {
    Block block(model);
    Random random(1);
    for (std::size_t tree = 0; tree < lanes; ++tree)
        for (std::size_t k = 0; k < block.modes(); ++k) {
            block.amplitude(k, tree) = 0.01f * random.symmetric() * model.modes[k].limit;
            block.speed(k, tree) = 0.01f * random.symmetric() * model.modes[k].limit * model.modes[k].omega;
        }
    return block;
}

TEST(ModalKernel, EnergyIsConservedWithoutDamping) {
    // Measured: up by 1.3e-6, down by 2.7e-4.
    const ModalModel model = withoutDamping(oak());
    Block block = movingBlock(model);
    Random random(5);
    std::array<double, lanes> before, highest, lowest;
    for (std::size_t tree = 0; tree < lanes; ++tree)
        before[tree] = highest[tree] = lowest[tree] = block.energy(tree);
    for (int i = 0; i < 100000; ++i) {
        block.step(anyStep(random));
        for (std::size_t tree = 0; tree < lanes; ++tree) {
            const double energy = block.energy(tree);
            highest[tree] = std::max(highest[tree], energy);
            lowest[tree] = std::min(lowest[tree], energy);
        }
    }
    for (std::size_t tree = 0; tree < lanes; ++tree) {
        EXPECT_LT(highest[tree] / before[tree] - 1.0, 1e-4) << "energy rose, tree " << tree;
        EXPECT_GT(lowest[tree] / before[tree] - 1.0, -1e-3) << "energy was lost, tree " << tree;
    }
}

TEST(ModalKernel, EqualStepsAccumulateOnlyRoundingErrors) {
    // Equal steps are rounded alike each time, by up to one unit in the last place.
    const ModalModel model = withoutDamping(oak());
    constexpr int steps = 20000;
    for (const float seconds : {1e-5f, 1e-3f, 1.0f / 240.0f, 1.0f / 60.0f, 1.0f / 30.0f, 0.1f}) {
        Block block = movingBlock(model);
        const double before = block.energy(0);
        for (int i = 0; i < steps; ++i)
            block.step(seconds);
        EXPECT_NEAR(block.energy(0) / before, 1.0, steps * Limits::epsilon())
            << "steps of " << seconds << " s";
    }
}

TEST(ModalKernel, AnyStepInAnyWindStaysWithinLimits) {
    Block block(oak());
    Random random(2);
    for (int i = 0; i < 200000; ++i) {
        for (std::size_t tree = 0; tree < lanes; ++tree)
            block.setWind(tree, anyWind(random, 75.0f));
        block.step(anyStep(random));
        const auto tree = static_cast<std::size_t>(i) % lanes;
        ASSERT_TRUE(block.sound(tree)) << "step " << i << ", tree " << tree;
    }
}

TEST(ModalKernel, AHurricaneBendsATreeWithoutOscillation) {
    // A sudden 75 m/s with the longest time steps must not excite an oscillation.
    Block block(oak());
    for (std::size_t tree = 0; tree < lanes; ++tree)
        block.setWind(tree, {75.0f, 0.0f, 0.0f});
    for (int i = 0; i < 600; ++i)
        block.step(0.1f, 3);
    const float steady = block.largestAngle(0);
    for (int i = 0; i < 100; ++i) {
        block.step(0.1f, 3);
        ASSERT_NEAR(block.largestAngle(0), steady, 1e-3f * steady) << "step " << i;
    }
}

/// Seven invalid winds, and calm for a tree that is to stay unaffected.
constexpr std::array<float, 8> winds{
    6.0f,   Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), 1e30f,
    -1e30f, Limits::max(),      Limits::denorm_min()};

TEST(ModalKernel, RecoversFromAnInvalidWind) {
    Block block(oak());
    const auto blow = [&](bool bad, int frames) {
        for (int i = 0; i < frames; ++i) {
            for (std::size_t tree = 0; tree < lanes; ++tree) {
                const float good = 6.0f + 2.0f * std::sin(0.1f * static_cast<float>(i));
                block.setWind(tree, {bad && tree > 0 ? winds[tree] : good, 1.0f, 0.0f});
            }
            block.step(1.0f / 60.0f);
            for (std::size_t tree = 0; tree < lanes; ++tree)
                ASSERT_TRUE(block.sound(tree)) << "wind " << winds[tree] << ", frame " << i;
        }
    };
    blow(false, 60);
    blow(true, 60);
    blow(false, 1);
    for (std::size_t tree = 0; tree < lanes; ++tree)
        EXPECT_LT(block.largestAngle(tree), 1.0f) << "after wind " << winds[tree];
    blow(false, 60 * 60);
    for (std::size_t tree = 1; tree < lanes; ++tree)
        for (std::size_t k = 0; k < block.modes(); ++k)
            EXPECT_NEAR(block.amplitude(k, tree), block.amplitude(k, 0),
                        1e-2f * std::abs(block.amplitude(0, 0)))
                << "mode " << k << " after wind " << winds[tree];
}

/// Trees of several sizes after all kinds of wind.
Block weathered(const std::function<void(const ModalStep&)>& kernel) {
    Block block(oak());
    Random random(3);
    for (std::size_t tree = 0; tree < lanes; ++tree) {
        TreeFactors factors;
        factors.length = 0.7f + 0.1f * static_cast<float>(tree);
        factors.omegaSquare = 1.0f / factors.length;
        factors.cosine = std::cos(static_cast<float>(tree));
        factors.sine = std::sin(static_cast<float>(tree));
        factors.logs = {0.2f * random.symmetric(), 0.2f * random.symmetric(), 0.1f * random.symmetric(),
                        0.0f};
        factors.leafDrag = 0.5f + random.uniform();
        block.setFactors(tree, factors);
    }
    for (int i = 0; i < 3000; ++i) {
        for (std::size_t tree = 0; tree < lanes; ++tree)
            block.setWind(tree, i % 500 == 7 ? glm::vec3(winds[tree]) : anyWind(random, 30.0f));
        block.step(anyStep(random), 1 + i % 3, kernel);
    }
    return block;
}

void expectSameBits(const Block& block, const Block& expected, const char* name) {
    for (std::size_t tree = 0; tree < lanes; ++tree) {
        const std::vector<float> a = block.state(tree), b = expected.state(tree);
        for (std::size_t i = 0; i < a.size(); ++i)
            ASSERT_EQ(std::memcmp(&a[i], &b[i], sizeof(float)), 0)
                << name << ", tree " << tree << ", number " << i << ": " << a[i] << " against " << b[i];
    }
}

Block weathered(InstructionSet set) {
    return weathered([set](const ModalStep& step) { stepTrees(step, set); });
}

TEST(ModalKernel, CompilersWithoutVectorsGiveTheSameBits) {
    expectSameBits(weathered(stepTreesPlain), weathered(InstructionSet::Baseline), "plain");
}

TEST(ModalKernel, AllInstructionSetsGiveTheSameBits) {
    const std::vector<InstructionSet> sets = instructionSets();
    if (sets.size() < 2)
        GTEST_SKIP() << "this machine has " << nameOf(sets.front()) << " only";
    const Block expected = weathered(sets.front());
    for (const InstructionSet set : sets)
        expectSameBits(weathered(set), expected, nameOf(set));
    if (sets.size() < 3)
        GTEST_SKIP() << "this machine has no instruction set beyond " << nameOf(sets.back());
}

TEST(ModalKernel, TheEnvironmentLimitsTheInstructionSet) {
    const EnvironmentVariable baseline("OSGTREEWIND_INSTRUCTIONS", "baseline");
    EXPECT_EQ(bestInstructionSet(), InstructionSet::Baseline);
}

TEST(ModalKernel, TreesInABlockAreIndependent) {
    for (const InstructionSet set : instructionSets()) {
        Block crowded(oak()), alone(oak());
        Random random(4);
        for (std::size_t tree = 0; tree < lanes; ++tree)
            if (tree != 5)
                for (std::size_t k = 0; k < crowded.modes(); ++k)
                    crowded.amplitude(k, tree) = random.symmetric() * 100.0f;
        for (int i = 0; i < 2000; ++i) {
            for (std::size_t tree = 0; tree < lanes; ++tree)
                crowded.setWind(tree, tree % 2 == 0 ? glm::vec3(winds[tree]) : anyWind(random, 60.0f));
            const glm::vec3 wind = anyWind(random, 15.0f);
            crowded.setWind(5, wind);
            alone.setWind(5, wind);
            const float seconds = anyStep(random);
            crowded.step(seconds, 1, set);
            alone.step(seconds, 1, set);
        }
        EXPECT_EQ(crowded.state(5), alone.state(5)) << nameOf(set);
    }
}

TEST(ModalKernel, ComesToRestInCalm) {
    // Denormal numbers would slow down a processor.
    const ModalModel model = modelOf("broadleaf", {10, 0.2f, 0}, 0.08f);
    Block block(model);
    for (std::size_t tree = 0; tree < lanes; ++tree)
        block.setWind(tree, {8.0f, 3.0f, 0.5f});
    for (int i = 0; i < 600; ++i)
        block.step(1.0f / 60.0f);
    for (std::size_t tree = 0; tree < lanes; ++tree)
        block.setWind(tree, glm::vec3(0.0f));
    for (int i = 0; i < 300 * 60; ++i) {
        block.step(1.0f / 60.0f);
        for (const float number : block.state(0))
            ASSERT_NE(std::fpclassify(number), FP_SUBNORMAL) << "frame " << i;
    }
    for (const float number : block.state(0))
        EXPECT_EQ(number, 0.0f);
}

/// A model with one mode, whose amplitude is the displacement of its only patch along x.
ModalModel onePatch(float drag, float streamlining, float breezeStreamlining) {
    ModalModel model;
    model.modes.resize(1);
    model.modes[0].omega = 2.0f;
    model.modes[0].limit = 100.0f;
    model.patches.resize(1);
    model.patches[0].leafDrag = drag;
    model.patches[0].streamlining = streamlining;
    model.patches[0].breezeStreamlining = breezeStreamlining;
    model.levers = {1.0f, 0.0f, 0.0f};
    model.brakes = {1.0f};
    model.dampingRatio = 0.01f;
    return model;
}

/// Decay rate of a small sway about the static lean in a steady wind, 1/s.
double rateIn(const ModalModel& model, const glm::vec3& wind, double force, float shelter = 1.0f) {
    constexpr double small = 0.05, seconds = 1.0 / 240.0;
    const double omega = model.modes[0].omega, lean = force / (omega * omega);
    Block block(model);
    TreeFactors factors;
    factors.shelter = shelter;
    block.setFactors(0, factors);
    block.amplitude(0, 0) = static_cast<float>(lean + small);
    block.setWind(0, wind);
    block.step(1.0f, 0);
    const int steps = static_cast<int>(std::lround(2.0 * 6.283185307 / omega / seconds)); // two swings
    for (int i = 0; i < steps; ++i)
        block.step(static_cast<float>(seconds));
    const double left =
        std::hypot(static_cast<double>(block.amplitude(0, 0)) - lean, block.speed(0, 0) / omega);
    return std::log(small / left) / (steps * seconds);
}

TEST(ModalKernel, SteadyAirDampsByTheSlopeOfItsDrag) {
    // Drag k u^(2-n) damps sway along the wind by its slope (2-n) k u^(1-n), across it by k u^(1-n).
    constexpr float drag = 0.01f;
    const auto expectSlope = [&](float speed, float n, const ModalModel& model) {
        SCOPED_TRACE("n " + std::to_string(n) + ", " + std::to_string(speed) + " m/s");
        const double share = std::pow(static_cast<double>(speed) / 10.0, -static_cast<double>(n));
        const double brake = static_cast<double>(drag) * share * speed, wood = 0.01 * 2.0;
        EXPECT_NEAR(rateIn(model, {speed, 0, 0}, brake * speed) / (wood + 0.5 * (2.0 - n) * brake), 1.0,
                    0.01);
        EXPECT_NEAR(rateIn(model, {0, speed, 0}, 0.0) / (wood + 0.5 * brake), 1.0, 0.01);
    };
    for (const float speed : {3.0f, 6.0f, 15.0f})
        expectSlope(speed, 0.0f, onePatch(drag, 0.0f, 0.0f));
    for (const float n : {0.36f, 0.8f}) {
        expectSlope(4.0f, n, onePatch(drag, 0.0f, n));
        expectSlope(15.0f, n, onePatch(drag, n, 0.0f));
    }
}

TEST(ModalKernel, ShelterReducesAerodynamicDamping) {
    // F = k (s (U - v))^2: a sway in the sheltered wind s U is damped by s times the slope.
    constexpr float drag = 0.01f, speed = 6.0f, shelter = 0.5f;
    const ModalModel model = onePatch(drag, 0.0f, 0.0f);
    const double brake = static_cast<double>(drag * speed), wood = 0.01 * 2.0;
    EXPECT_NEAR(rateIn(model, {speed, 0, 0}, brake * speed, shelter) / (wood + shelter * brake), 1.0, 0.01);
    EXPECT_NEAR(rateIn(model, {0, speed, 0}, 0.0, shelter) / (wood + 0.5 * shelter * brake), 1.0, 0.01);
}

TEST(ModalKernel, InStillAirShelterHasNoEffect) {
    const ModalModel model = onePatch(0.1f, 0.0f, 0.0f);
    EXPECT_NEAR(rateIn(model, glm::vec3(0.0f), 0.0, 0.3f), rateIn(model, glm::vec3(0.0f), 0.0), 1e-4);
}

TEST(ModalKernel, ZeroSubstepsSetTheWindAndMoveNothing) {
    Block block(oak());
    block.amplitude(0, 3) = 1.0f;
    block.setWind(3, {4.0f, 3.0f, 2.0f});
    block.step(1.0f, 0);
    const std::vector<float> state = block.state(3);
    EXPECT_EQ(state[0], 1.0f);
    EXPECT_EQ(state[1], 0.0f);
    EXPECT_EQ(state[2 * block.modes()], 4.0f);
    EXPECT_EQ(state[2 * block.modes() + 1], 3.0f);
    EXPECT_EQ(state[2 * block.modes() + 2], 2.0f);
}

} // namespace
} // namespace osgTreeWind
