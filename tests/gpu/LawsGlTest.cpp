// SPDX-License-Identifier: MIT
#include "../gl/GlTest.h"

#include <osgTreeWind/gpu/AnglePass.h>
#include <osgTreeWind/gpu/AngleReadback.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/motion/Laws.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace osgTreeWind {
namespace {

struct Case {
    glm::vec4 state;
    glm::vec3 wind, noise;
};

/// Every wind with every noise, from a few states.
std::vector<Case> sweep(const std::vector<float>& winds, const std::vector<float>& noises,
                        const std::vector<float>& angles) {
    std::vector<Case> cases;
    for (const float angle : angles)
        for (const float x : winds)
            for (const float z : winds)
                for (const float n1 : noises)
                    for (const float n3 : noises)
                        cases.push_back({{angle, -0.5f * angle, 0.0f, 0.0f}, {x, 0.5f * z, z}, {n1, n3, n3}});
    return cases;
}

/// One step of a law on the GPU, given all its inputs: the text of the passes' law files and nothing else of
/// ours.
class LawsGlTest : public GlTest {
protected:
    std::vector<glm::vec4> step(const std::vector<Case>& cases, const std::string& body) {
        std::vector<glm::vec4> states, winds, noises;
        for (const Case& c : cases) {
            states.push_back(c.state);
            winds.emplace_back(c.wind, 0.0f);
            noises.emplace_back(c.noise, 0.0f);
        }
        AnglePass pass("branch_angles", &states[0].x, states.size());
        const DataTexture wind = texture("wind", winds), noise = texture("noise", noises);
        pass.inputs().setTextureAttribute(1, wind.texture());
        pass.inputs().setTextureAttribute(2, noise.texture());
        pass.inputs().addUniform(new osg::Uniform("winds", 1));
        pass.inputs().addUniform(new osg::Uniform("noises", 2));
        pass.inputs().setAttributeAndModes(program(body), osg::StateAttribute::ON |
                                                              osg::StateAttribute::OVERRIDE |
                                                              osg::StateAttribute::PROTECTED);
        osg::ref_ptr<AngleReadback> readback = new AngleReadback;
        pass.setPostDrawCallback(readback);
        pass.step();
        open(16, 16);
        viewer().setSceneData(pass.node());
        frame(0.0);
        std::vector<glm::vec4> result;
        unsigned number = 0;
        EXPECT_TRUE(readback->take(result, number));
        result.resize(cases.size());
        return result;
    }

private:
    static DataTexture texture(const char* name, const std::vector<glm::vec4>& texels) {
        DataTexture texture(name, texels.size());
        std::memcpy(texture.data(), texels.data(), texels.size() * sizeof(glm::vec4));
        return texture;
    }

    static osg::ref_ptr<osg::Program> program(const std::string& body) {
        std::string text = "#version 330 compatibility\n";
        for (const char* file : {"data.glsl", "target.glsl", "law/limits.glsl", "law/rotation.glsl",
                                 "law/thesis_branch.glsl", "law/thesis_leaf.glsl", "law/damped_branch.glsl"})
            text += shaderText(file);
        text += "uniform sampler2D previousAngles, winds, noises;\n"
                "void main() {\n"
                "    int i = targetIndex(previousAngles);\n"
                "    vec4 state = dataTexel(previousAngles, i);\n"
                "    vec3 wind = dataTexel(winds, i).xyz;\n"
                "    vec3 noise = dataTexel(noises, i).xyz;\n"
                "    gl_FragColor = " +
                body + ";\n}\n";
        osg::ref_ptr<osg::Program> program = new osg::Program;
        program->addShader(new osg::Shader(osg::Shader::VERTEX, shaderText("texels.vert")));
        program->addShader(new osg::Shader(osg::Shader::FRAGMENT, text));
        return program;
    }
};

const std::vector<float> winds = {0.0f, 1e-6f, -1e-6f, 0.1f, -0.1f, 2.0f, -2.0f, 9.0f, -9.0f};
const std::vector<float> noises = {0.0f, 1e-6f, -1e-6f, 0.3f, -0.3f};
const std::vector<float> angles = {0.0f, 0.2f, -0.45f};

float difference(const glm::vec4& a, const glm::vec4& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z), std::abs(a.w - b.w)});
}

TEST_F(LawsGlTest, ThesisBranchAgreesWithTheCpu) {
    const std::vector<Case> cases = sweep(winds, noises, angles);
    const auto gpu =
        step(cases, "thesisBranchStep(state, wind, noise, ThesisBranch(40.0, 1.5, 0.5, 8.0, 0.0))");
    const Laws::ThesisBranch branch{40.0f, 1.5f, 0.5f, 8.0f, 0.0f};
    for (std::size_t i = 0; i < cases.size(); ++i)
        ASSERT_LT(difference(gpu[i],
                             Laws().thesisBranchStep(cases[i].state, cases[i].wind, cases[i].noise, branch)),
                  5e-4f)
            << i;
}

TEST_F(LawsGlTest, ThesisSmoothBranchAgreesWithTheCpu) {
    const std::vector<Case> cases = sweep(winds, noises, angles);
    const auto gpu =
        step(cases, "thesisSmoothBranchStep(state, wind, noise, ThesisBranch(40.0, 1.5, 0.5, 8.0, 0.2))");
    const Laws::ThesisBranch branch{40.0f, 1.5f, 0.5f, 8.0f, 0.2f};
    for (std::size_t i = 0; i < cases.size(); ++i)
        ASSERT_LT(difference(gpu[i], Laws().thesisSmoothBranchStep(cases[i].state, cases[i].wind,
                                                                   cases[i].noise, branch)),
                  5e-4f)
            << i;
}

TEST_F(LawsGlTest, LeafAgreesWithTheCpu) {
    const std::vector<Case> cases = sweep(winds, noises, angles);
    const auto gpu =
        step(cases, "thesisLeafStep(state, noise.x, noise.y, ThesisLeaf(0.5, 0.2, 1.0, 4.0, 1.0, 0.7))");
    const Laws::ThesisLeaf leaf{0.5f, 0.2f, 1.0f, 4.0f, 1.0f, 0.7f};
    for (std::size_t i = 0; i < cases.size(); ++i)
        ASSERT_LT(difference(gpu[i],
                             Laws().thesisLeafStep(cases[i].state, cases[i].noise.x, cases[i].noise.y, leaf)),
                  5e-4f)
            << i;
}

TEST_F(LawsGlTest, HostileInputGivesFiniteAnglesWithinLimits) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> hostile = {inf, -inf, nan, 1e30f, -1e30f, 1e-42f, 0.0f};
    const std::vector<Case> cases = sweep(hostile, hostile, hostile);
    const char* laws[] = {
        "thesisBranchStep(state, wind, noise, ThesisBranch(40.0, 1.5, 0.5, 8.0, 0.0))",
        "thesisSmoothBranchStep(state, wind, noise, ThesisBranch(40.0, 1.5, 0.5, 8.0, 0.2))",
        "thesisLeafStep(state, noise.x, noise.y, ThesisLeaf(0.5, 0.5, 0.5, 4.0, 1.0, 0.7))"};
    for (const char* law : laws) {
        for (const glm::vec4& angle : step(cases, law)) {
            ASSERT_TRUE(std::isfinite(angle.x) && std::isfinite(angle.y)) << law;
            ASSERT_LE(std::max(std::abs(angle.x), std::abs(angle.y)), 0.5f) << law;
        }
    }
}

} // namespace
} // namespace osgTreeWind
