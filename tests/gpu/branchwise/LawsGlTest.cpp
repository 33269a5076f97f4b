// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/gpu/branchwise/AnglePass.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/NoiseTime.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace osgTreeWind {
namespace {

using Texels = std::vector<glm::vec4>;
using Inputs = std::vector<std::pair<std::string, Texels>>;

/// One step of a law on the GPU with given inputs, using only the law files of the passes.
class LawsGlTest : public GlTest {
protected:
    /// @param inputs by name, with a texel per state. @param body expression that uses these names.
    Texels step(const Texels& states, const Inputs& inputs, const std::string& body) {
        AnglePass pass("branchwise/branch_angles", states);
        unsigned unit = 1;
        std::string declared;
        std::vector<DataTexture> textures;
        for (const auto& [name, texels] : inputs) {
            textures.emplace_back(name.c_str(), texels.size());
            textures.back().fill(texels);
            bindDataTexture(pass.inputs(), (name + "Texels").c_str(), unit++, textures.back().texture());
            declared += "uniform sampler2D " + name + "Texels;\n#define " + name + " dataTexel(" + name +
                        "Texels, targetIndex(previousAngles))\n";
        }
        pass.inputs().setAttributeAndModes(program(declared, body), osg::StateAttribute::ON |
                                                                        osg::StateAttribute::OVERRIDE |
                                                                        osg::StateAttribute::PROTECTED);
        pass.step();
        reopen(16, 16);
        viewer().setSceneData(pass.node());
        frame(0.0);
        Texels result;
        EXPECT_TRUE(pass.readBack(result));
        result.resize(states.size());
        return result;
    }

private:
    static osg::ref_ptr<osg::Program> program(const std::string& declared, const std::string& body) {
        std::string text;
        for (const char* file :
             {"data.glsl", "target.glsl", "real.glsl", "law/limits.glsl", "law/elementary.glsl",
              "law/noise.glsl", "law/rotation.glsl", "law/thesis_branch.glsl", "law/thesis_leaf.glsl",
              "law/flutter.glsl", "law/shoot.glsl", "law/oscillator.glsl", "law/modal.glsl",
              "law/reconfiguration.glsl"})
            text += shaderText(file);
        text += "uniform sampler2D previousAngles;\n" + declared +
                "out vec4 result;\nvoid main() {\n"
                "    vec4 state = dataTexel(previousAngles, targetIndex(previousAngles));\n"
                "    result = " +
                body + ";\n}\n";
        return makeProgram("law", shaderText("texels.vert"), text);
    }
};

struct Sweep {
    Texels states, winds, noises;

    Inputs inputs() const { return {{"wind", winds}, {"noise", noises}}; }
};

/// All combinations of winds, noises and a few states.
Sweep sweep(const std::vector<float>& winds, const std::vector<float>& noises,
            const std::vector<float>& angles) {
    Sweep all;
    for (const float angle : angles)
        for (const float x : winds)
            for (const float z : winds)
                for (const float n1 : noises)
                    for (const float n3 : noises) {
                        all.states.emplace_back(angle, -0.5f * angle, 0.0f, 0.0f);
                        all.winds.emplace_back(x, 0.5f * z, z, 0.0f);
                        all.noises.emplace_back(n1, n3, n3, 0.0f);
                    }
    return all;
}

Sweep usual() {
    return sweep({0.0f, 1e-6f, -1e-6f, 0.1f, -0.1f, 2.0f, -2.0f, 9.0f, -9.0f},
                 {0.0f, 1e-6f, -1e-6f, 0.3f, -0.3f}, {0.0f, 0.2f, -0.45f});
}

float difference(const glm::vec4& a, const glm::vec4& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z), std::abs(a.w - b.w)});
}

TEST_F(LawsGlTest, ThesisBranchAgreesWithTheCpu) {
    const Sweep s = usual();
    const Texels gpu =
        step(s.states, s.inputs(),
             "thesisBranchStep(state, wind.xyz, noise.xyz, ThesisBranch(40.0, 1.5, 0.5, 8.0, 0.0))");
    const Laws::ThesisBranch branch{40.0f, 1.5f, 0.5f, 8.0f, 0.0f};
    for (std::size_t i = 0; i < gpu.size(); ++i)
        ASSERT_LT(difference(gpu[i], Laws().thesisBranchStep(s.states[i], s.winds[i], s.noises[i], branch)),
                  5e-4f)
            << i;
}

TEST_F(LawsGlTest, FlutterAgreesWithTheCpu) {
    Texels states, phases;
    for (int i = 0; i < 500; ++i) {
        states.emplace_back(0.05f * static_cast<float>(i), 0.002f * static_cast<float>(i),
                            4.0f * static_cast<float>(i), 0.6f + 0.0016f * static_cast<float>(i));
        const float turns = 0.37f * static_cast<float>(i);
        phases.emplace_back(glm::fract(turns), glm::fract(1.6f * turns), glm::fract(2.3f * turns), 0.0f);
    }
    const Texels gpu = step(states, {{"phases", phases}},
                            "vec4(leafFlutter(state.x, state.w, phases.xyz, state.y, state.z, "
                            "vec4(0.4, 0.3, 0.6, 0.7)), 0.0)");
    Laws laws;
    for (std::size_t i = 0; i < gpu.size(); ++i) {
        const glm::vec4& s = states[i];
        const glm::vec3 cpu =
            laws.leafFlutter(s.x, s.w, glm::vec3(phases[i]), s.y, s.z, {0.4f, 0.3f, 0.6f, 0.7f});
        ASSERT_LT(difference(gpu[i], glm::vec4(cpu, 0.0f)), 1e-3f) << i;
    }
}

TEST_F(LawsGlTest, TrembleAgreesWithTheCpu) {
    Random random(11);
    Texels corners, phases;
    for (int i = 0; i < 300; ++i) {
        corners.emplace_back(random.symmetric(), random.symmetric(), random.uniform(),
                             30.0f * random.uniform());
        phases.emplace_back(random.uniform(), random.uniform(), random.uniform(), static_cast<float>(i));
    }
    const Texels gpu =
        step(corners, {{"phases", phases}},
             "vec4(trembleWave(state.xyz, phases.xyz, 0.3, phases.w), trembleShare(state.w, 22.0))");
    Laws laws;
    for (std::size_t i = 0; i < gpu.size(); ++i) {
        const glm::vec4& c = corners[i];
        const glm::vec3 cpu = laws.trembleWave(glm::vec3(c), glm::vec3(phases[i]), 0.3f, phases[i].w);
        ASSERT_LT(difference(gpu[i], glm::vec4(cpu, laws.trembleShare(c.w, 22.0f))), 1e-3f) << i;
    }
}

TEST_F(LawsGlTest, ShootSwayAgreesWithTheCpu) {
    Random random(7);
    Texels places, phases;
    for (int i = 0; i < 300; ++i) {
        places.emplace_back(8.0f * random.symmetric(), 8.0f * random.symmetric(), 20.0f * random.uniform(),
                            3.0f * random.uniform());
        phases.emplace_back(random.uniform(), random.uniform(), random.uniform(), 20.0f * random.uniform());
    }
    const Texels gpu = step(places, {{"phases", phases}},
                            "vec4(shootSway(state.xyz, state.w, phases.w, phases.xyz, 0.3), 0.0)");
    Laws laws;
    for (std::size_t i = 0; i < gpu.size(); ++i) {
        const glm::vec3 cpu =
            laws.shootSway(glm::vec3(places[i]), places[i].w, phases[i].w, glm::vec3(phases[i]), 0.3f);
        ASSERT_LT(difference(gpu[i], glm::vec4(cpu, 0.0f)), 1e-3f) << i;
    }
}

TEST_F(LawsGlTest, PullAgreesWithTheCpu) {
    Texels winds;
    for (const float x : {0.0f, 0.3f, -2.0f, 9.9f, 10.1f, -26.0f, 80.0f})
        for (const float y : {0.0f, 4.0f, -17.0f})
            for (const float z : {0.0f, 1.0f, -3.0f})
                winds.emplace_back(x, y, z, 0.0f);
    const Texels gpu = step(winds, {}, "foliagePull(state.xyz, 0.88, 0.35, 20.0, 1.2)");
    for (std::size_t i = 0; i < gpu.size(); ++i)
        ASSERT_LT(difference(gpu[i], Laws().foliagePull(glm::vec3(winds[i]), 0.88f, 0.35f, 20.0f, 1.2f)),
                  1e-5f)
            << i;
}

TEST_F(LawsGlTest, TurnDownwindAgreesWithTheCpu) {
    Random random(5);
    Texels petioles, pulls;
    for (int i = 0; i < 300; ++i) {
        const glm::vec3 petiole(random.symmetric(), random.symmetric(), random.symmetric());
        petioles.emplace_back(glm::normalize(petiole), random.uniform());
        pulls.emplace_back(random.symmetric(), random.symmetric(), random.symmetric(), 1.0f);
    }
    pulls[0] = glm::vec4(0.0f);
    const std::string gusty = "pull.xyz * pullOfGusts(4.0 * state.xyz, pull.xyz, state.www, 0.3, 9.0)";
    const Texels gpu = step(petioles, {{"pull", pulls}}, "downwindTurn(state.xyz, " + gusty + ")");
    Laws laws;
    for (std::size_t i = 0; i < gpu.size(); ++i) {
        const glm::vec3 petiole(petioles[i]), pull(pulls[i]);
        const float gust = laws.pullOfGusts(4.0f * petiole, pull, glm::vec3(petioles[i].w), 0.3f, 9.0f);
        ASSERT_LT(difference(gpu[i], laws.downwindTurn(petiole, gust * pull)), 1e-4f) << i;
    }
}

TEST_F(LawsGlTest, ModalStepAgreesWithTheCpu) {
    Texels states, numbers, air;
    Laws laws;
    for (const float force : {0.0f, -3.0f, 40.0f})
        for (const float brake : {0.0f, 0.3f, 8.0f, 60.0f})
            for (const float pace : {0.5f, 2.0f, 9.0f, 40.0f})
                for (const float angle : {0.0f, -0.2f, 0.7f}) {
                    states.emplace_back(angle, 1.0f - angle, 0.0f, 0.0f);
                    numbers.emplace_back(force, brake, pace, 0.04f);
                    air.emplace_back(2.0f * pace, 0.5f * brake, 3.0f + force * force, 5.0f * pace);
                }
    const std::string mode = "modeStep(Swing(state.x, state.y), n.x, n.y, n.z, n.w, 5.0, 0.0166667)";
    std::string body =
        "vec4(" + mode + ".angle, " + mode +
        ".speed, airBrake(2.0, 7.0, swinging(air.x, air.y), air.z), streamlinedShare(0.8, 0.4, 30.0, air.w))";
    const Texels gpu = step(states, {{"n", numbers}, {"air", air}}, body);
    for (std::size_t i = 0; i < gpu.size(); ++i) {
        const glm::vec4 &n = numbers[i], &a = air[i];
        const Laws::Swing swing =
            laws.modeStep({states[i].x, states[i].y}, n.x, n.y, n.z, n.w, 5.0f, 0.0166667f);
        const float brake = laws.airBrake(2.0f, 7.0f, laws.swinging(a.x, a.y), a.z);
        ASSERT_NEAR(gpu[i].x, swing.angle, 3e-5f) << i;
        ASSERT_NEAR(gpu[i].y, swing.speed, 1e-4f) << i;
        ASSERT_NEAR(gpu[i].z / brake, 1.0f, 1e-5f) << i;
        ASSERT_NEAR(gpu[i].w, laws.streamlinedShare(0.8f, 0.4f, 30.0f, a.w), 1e-5f) << i;
    }
}

TEST_F(LawsGlTest, ThesisSmoothBranchAgreesWithTheCpu) {
    const Sweep s = usual();
    const Texels gpu =
        step(s.states, s.inputs(),
             "thesisSmoothBranchStep(state, wind.xyz, noise.xyz, ThesisBranch(40.0, 1.5, 0.5, 8.0, 0.2))");
    const Laws::ThesisBranch branch{40.0f, 1.5f, 0.5f, 8.0f, 0.2f};
    for (std::size_t i = 0; i < gpu.size(); ++i)
        ASSERT_LT(
            difference(gpu[i], Laws().thesisSmoothBranchStep(s.states[i], s.winds[i], s.noises[i], branch)),
            5e-4f)
            << i;
}

TEST_F(LawsGlTest, LeafAgreesWithTheCpu) {
    const Sweep s = usual();
    const Texels gpu =
        step(s.states, s.inputs(),
             "thesisLeafStep(state, noise.x, noise.y, ThesisLeaf(0.5, 0.2, 1.0, 4.0, 1.0, 0.7))");
    const Laws::ThesisLeaf leaf{0.5f, 0.2f, 1.0f, 4.0f, 1.0f, 0.7f};
    for (std::size_t i = 0; i < gpu.size(); ++i)
        ASSERT_LT(difference(gpu[i], Laws().thesisLeafStep(s.states[i], s.noises[i].x, s.noises[i].y, leaf)),
                  5e-4f)
            << i;
}

TEST_F(LawsGlTest, NoiseAgreesWithTheCpu) {
    Random random(3);
    Texels times;
    for (int i = 0; i < 5000; ++i)
        times.emplace_back(std::floor(65536.0f * random.uniform()), random.uniform(), 0.0f, 0.0f);
    for (const float gain : {0.0f, 0.5f, 1.0f, 1.4142136f}) {
        const Texels gpu =
            step(times, {},
                 "vec4(motionNoise(noiseStream(7u, uint(state.x), 3u), uint(state.x), state.y, " +
                     std::to_string(gain) + "))");
        for (std::size_t i = 0; i < gpu.size(); ++i) {
            const auto cell = static_cast<std::uint32_t>(times[i].x);
            ASSERT_NEAR(gpu[i].x,
                        Laws().motionNoise(Laws().noiseStream(7u, cell, 3u), cell, times[i].y, gain), 2e-5f)
                << "gain " << gain;
        }
    }
}

TEST_F(LawsGlTest, InvalidInputGivesFiniteAnglesWithinLimits) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> hostile = {inf, -inf, nan, 1e30f, -1e30f, 1e-42f, 0.0f};
    const Sweep s = sweep(hostile, hostile, hostile);
    const char* laws[] = {
        "thesisBranchStep(state, wind.xyz, noise.xyz, ThesisBranch(40.0, 1.5, 0.5, 8.0, 0.0))",
        "thesisSmoothBranchStep(state, wind.xyz, noise.xyz, ThesisBranch(40.0, 1.5, 0.5, 8.0, 0.2))",
        "thesisLeafStep(state, noise.x, noise.y, ThesisLeaf(0.5, 0.5, 0.5, 4.0, 1.0, 0.7))"};
    for (const char* law : laws) {
        for (const glm::vec4& angle : step(s.states, s.inputs(), law)) {
            ASSERT_TRUE(std::isfinite(angle.x) && std::isfinite(angle.y) && std::isfinite(angle.z) &&
                        std::isfinite(angle.w))
                << law;
            ASSERT_LE(std::max(std::abs(angle.x), std::abs(angle.y)), 0.5f) << law;
        }
    }
}

} // namespace
} // namespace osgTreeWind
