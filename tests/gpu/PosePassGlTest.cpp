// SPDX-License-Identifier: MIT
#include <tests/NamesInOrder.h>
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/gpu/PosePass.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/laws/PosedPoints.h>
#include <osgTreeWind/motion/laws/Reconfiguration.h>

#include <osg/ClipPlane>
#include <osg/GLExtensions>

#include <glm/geometric.hpp>

using namespace osgTreeWind;

namespace {

/// A drawable that requests poses as a cull traversal does, and reads them back. It draws nothing.
class PoseReader : public osg::Drawable {
public:
    PoseReader(const ForestSimulation& simulation, PosePass* passes)
        : _simulation(simulation), _passes(passes) {
        setCullingActive(false);
        setUseDisplayList(false);
    }

    void requestPose(unsigned frame, std::size_t tree) {
        const PlacedTree& placed = movingForest(_simulation).trees()[tree];
        places[tree] = _passes->request(
            frame, *movingForest(_simulation).modal(), static_cast<std::uint32_t>(tree), placed.model,
            placed.scale, Reconfiguration(movingForest(_simulation).placed().speciesOf(placed)));
    }

    void drawImplementation(osg::RenderInfo& info) const override {
        osg::State& state = *info.getState();
        for (const auto& [tree, place] : places) {
            const PlacedTree& placed = movingForest(_simulation).trees()[tree];
            const std::size_t units = movingForest(_simulation).placed().unitCount(placed);
            if (place.page != _read) { // a page at a time: the next one overwrites its poses
                _read = place.page;
                for (const unsigned unit :
                     {PosePass::rotationsUnit, PosePass::translationsUnit, PosePass::pullsUnit})
                    state.applyTextureAttribute(
                        unit, _passes->state()->getTextureAttribute(unit, osg::StateAttribute::TEXTURE));
                _passes->prepareBound(state, *place.page);
                _rotations = texels(state, PosePass::rotationsUnit);
                _translations = texels(state, PosePass::translationsUnit);
                _pulls = texels(state, PosePass::pullsUnit);
            }
            std::vector<UnitPose>& poses = read[tree];
            poses.clear();
            pulls[tree].clear();
            const std::size_t first = place.block * PosePage::blockUnits;
            for (std::size_t unit = 0; unit < units; ++unit) {
                const glm::vec4 r = _rotations[first + unit], t = _translations[first + unit];
                poses.push_back({glm::quat(r.w, r.x, r.y, r.z), glm::vec3(t)});
                winds[tree] = t.w;
                pulls[tree].push_back(_pulls[first + unit]);
            }
        }
        _read = nullptr;
    }

    std::map<std::size_t, PosePlaces::Place> places;           ///< By tree.
    mutable std::map<std::size_t, std::vector<UnitPose>> read; ///< By tree.
    mutable std::map<std::size_t, std::vector<glm::vec4>> pulls;
    mutable std::map<std::size_t, float> winds; ///< At the last unit.

private:
    static std::vector<glm::vec4> texels(osg::State& state, unsigned unit) {
        state.setActiveTextureUnit(unit);
        GLint width = 0, height = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
        std::vector<glm::vec4> texels(static_cast<std::size_t>(width * height));
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, texels.data());
        return texels;
    }

    const ForestSimulation& _simulation;
    osg::ref_ptr<PosePass> _passes;
    mutable osg::ref_ptr<const PosePage> _read;
    mutable std::vector<glm::vec4> _rotations, _translations, _pulls;
};

class PosePassGlTest : public GlTest {
protected:
    void startSimulation(ForestDescription description, ModalMotion::Level level = ModalMotion::Level::Near) {
        SimulationOptions options;
        options.distant = level == ModalMotion::Level::Far;
        simulation = std::make_unique<ForestSimulation>(std::move(description), options);
        passes = new PosePass(new PosePrograms);
        for (const auto& model : movingForest(*simulation).models())
            passes->addModel(model->skeleton);
        reader = new PoseReader(*simulation, passes);
        reopen(16, 16);
        viewer().setSceneData(reader);
    }
    void advanceSteps(int steps) {
        for (int i = 0; i <= steps; ++i)
            simulation->advance(i / 25.0);
    }
    void requestAllPoses(unsigned frame) {
        for (std::size_t tree = 0; tree < movingForest(*simulation).trees().size(); ++tree)
            reader->requestPose(frame, tree);
    }
    /// Maximum over the vertices of the bark, metres.
    struct Distances {
        float maxError = 0.0f;  ///< Distance between GPU and CPU.
        float maxMotion = 0.0f; ///< Distance from rest.
    };
    Distances distances(std::size_t tree) {
        const PlacedTree& placed = movingForest(*simulation).trees()[tree];
        const TreeMotion motion = movingForest(*simulation).motion(tree);
        const std::vector<UnitPose>& poses = reader->read.at(tree);
        Distances result;
        for (const SkinVertex& vertex : movingForest(*simulation).placed().modelOf(placed).skin().vertices) {
            const auto unit = static_cast<std::size_t>(vertex.unit + 0.5f);
            const glm::vec3 cpu = posedSkinPoint(vertex, placed.scale, motion.poses[unit]),
                            rest = posedSkinPoint(vertex, placed.scale, UnitPose());
            result.maxError = std::max(result.maxError,
                                       glm::distance(cpu, posedSkinPoint(vertex, placed.scale, poses[unit])));
            result.maxMotion = std::max(result.maxMotion, glm::distance(cpu, rest));
        }
        return result;
    }
    void expectPosesOfTheCpu(float minMotion) {
        for (std::size_t tree = 0; tree < movingForest(*simulation).trees().size(); ++tree) {
            const Distances found = distances(tree);
            ASSERT_LT(found.maxError, 1e-4f) << "tree " << tree;
            ASSERT_GT(found.maxMotion, minMotion)
                << "tree " << tree << " does not move: the test needs motion";
        }
    }

    std::unique_ptr<ForestSimulation> simulation;
    osg::ref_ptr<PosePass> passes;
    osg::ref_ptr<PoseReader> reader;
};

/// Trees of two species in several shapes and sizes.
ForestDescription mixedForest(float speed) {
    ForestDescription description = smallForest(6, speed);
    description.species.push_back(Species());
    description.species[1].shapes = 2;
    description.species[1].wood.streamlining = 0.8f;
    for (std::size_t i = 0; i < 6; i += 2)
        description.trees[i].species = 1;
    return description;
}

} // namespace

class PosePassLevelsGlTest : public PosePassGlTest,
                             public ::testing::WithParamInterface<ModalMotion::Level> {};

TEST_P(PosePassLevelsGlTest, VerticesAgreeWithTheCpu) {
    startSimulation(mixedForest(25.0f), GetParam());
    advanceSteps(60);
    requestAllPoses(0);
    frame(0.0);
    expectPosesOfTheCpu(0.05f);
    const glm::vec3 wind =
        movingForest(*simulation).motion(0).winds[movingForest(*simulation).motion(0).winds.size - 1];
    EXPECT_NEAR(reader->winds[0], glm::length(wind), 1e-4f) << "wind for the flutter of leaves";
    for (std::size_t tree = 0; tree < movingForest(*simulation).trees().size(); ++tree) {
        const TreeMotion motion = movingForest(*simulation).motion(tree);
        EXPECT_GT(glm::length(glm::vec3(motion.pulls[0])), 0.1f);
        for (std::size_t unit = 0; unit < motion.pulls.size; ++unit)
            ASSERT_LT(glm::length(reader->pulls[tree][unit] - motion.pulls[unit]), 1e-4f)
                << tree << ", " << unit;
    }
}

TEST_P(PosePassLevelsGlTest, FallenTreesAgreeWithTheCpu) {
    startSimulation(mixedForest(25.0f), GetParam());
    advanceSteps(60);
    for (std::size_t tree = 0; tree < movingForest(*simulation).trees().size(); ++tree) {
        const auto angle = 0.3f * static_cast<float>(tree + 1); // about one of the first three units
        TreeFall fall;
        fall.parts[0] = {4, {0.0f, 1.0f}};
        fall.parts[1] = {static_cast<unsigned>(tree % 3), angle * glm::vec2(0.6f, -0.8f)};
        fall.count = 2;
        fall.isDown = true;
        fall.sway = 0.5f;
        movingForest(*simulation).modal()->setFall(tree, fall);
    }
    requestAllPoses(0);
    frame(0.0);
    expectPosesOfTheCpu(1.0f);
}

INSTANTIATE_TEST_SUITE_P(NearAndFar, PosePassLevelsGlTest,
                         ::testing::Values(ModalMotion::Level::Near, ModalMotion::Level::Far),
                         NamesInOrder({"Near", "Far"}));

TEST_F(PosePassGlTest, PosesAreOfTheCurrentFrame) {
    startSimulation(mixedForest(15.0f));
    for (unsigned i = 0; i < 5; ++i) {
        simulation->advance(10 * i / 25.0);
        reader->places.clear();
        requestAllPoses(i);
        frame(i / 25.0);
        expectPosesOfTheCpu(i == 0 ? -1.0f : 1e-3f);
    }
}

namespace {

/// Sets OpenGL state that a host may have, and checks that a drawable keeps it.
struct HostState : osg::Drawable::DrawCallback {
    /// Values by name.
    static std::map<std::string, std::vector<GLint>> values(const osg::GLExtensions& gl) {
        std::map<std::string, std::vector<GLint>> result;
        const auto add = [&](const char* name, GLenum value, std::size_t count = 1) {
            std::vector<GLint>& numbers = result[name];
            numbers.resize(std::max<std::size_t>(count, 2));
            glGetIntegerv(value, numbers.data());
            numbers.resize(count);
        };
        add("viewport", GL_VIEWPORT, 4);
        add("polygon mode", GL_POLYGON_MODE);
        add("program", GL_CURRENT_PROGRAM);
        add("vertex array", GL_VERTEX_ARRAY_BINDING);
        add("frame buffer", GL_DRAW_FRAMEBUFFER_BINDING_EXT);
        for (const GLenum mode :
             {GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CLIP_PLANE0})
            result["mode " + std::to_string(mode)] = {glIsEnabled(mode)};
        for (GLuint i = 0; i < 3; ++i) {
            const std::string buffer = std::to_string(i);
            GLboolean mask[4] = {};
            GLboolean (*isEnabled)(GLenum, GLuint) = nullptr;
            void (*getBooleans)(GLenum, GLuint, GLboolean*) = nullptr;
            osg::setGLExtensionFuncPtr(isEnabled, "glIsEnabledi");
            osg::setGLExtensionFuncPtr(getBooleans, "glGetBooleani_v");
            getBooleans(GL_COLOR_WRITEMASK, i, mask);
            result["colour mask " + buffer].assign(mask, mask + 4);
            result["blend " + buffer] = {isEnabled(GL_BLEND, i)};
        }
        for (GLuint unit = 0; unit < 4; ++unit) {
            gl.glActiveTexture(GL_TEXTURE0 + unit);
            add(("texture " + std::to_string(unit)).c_str(), GL_TEXTURE_BINDING_2D);
        }
        return result;
    }

    void drawImplementation(osg::RenderInfo& info, const osg::Drawable* drawable) const override {
        const osg::GLExtensions& gl = *info.getState()->get<osg::GLExtensions>();
        GLuint textures[4] = {}, array = 0;
        glGenTextures(4, textures);
        for (GLuint unit = 0; unit < 4; ++unit) {
            gl.glActiveTexture(GL_TEXTURE0 + unit);
            glBindTexture(GL_TEXTURE_2D, textures[unit]);
        }
        gl.glGenVertexArrays(1, &array);
        gl.glBindVertexArray(array);
        for (const GLenum mode : {GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CLIP_PLANE0})
            glEnable(mode);
        gl.glEnablei(GL_BLEND, 1);
        gl.glColorMaski(2, GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        glViewport(1, 2, 3, 4);
        before = values(gl);
        info.getState()->setActiveTextureUnit(7);
        drawable->drawImplementation(info);
        after = values(gl);
        for (const GLenum mode : {GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CLIP_PLANE0, GL_BLEND})
            glDisable(mode);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        gl.glBindVertexArray(0);
    }
    mutable std::map<std::string, std::vector<GLint>> before, after;
};

} // namespace

TEST_F(PosePassGlTest, ThePassKeepsTheStateOfTheHost) {
    startSimulation(smallForest(3));
    advanceSteps(10);
    requestAllPoses(0);
    const osg::ref_ptr<HostState> state = new HostState;
    reader->setDrawCallback(state);
    frame(0.0);
    expectPosesOfTheCpu(1e-3f); // in spite of that state
    EXPECT_EQ(state->before.at("blend 1"), std::vector<GLint>{1});
    EXPECT_EQ(state->before, state->after);
}

TEST_F(PosePassGlTest, ATreeHasOnePlacePerFrame) {
    startSimulation(smallForest(3));
    advanceSteps(10);
    requestAllPoses(7);
    const std::map<std::size_t, PosePlaces::Place> places = reader->places;
    const osg::ref_ptr<PosePage> page = places.at(0).page;
    EXPECT_EQ(page->requests.size(), 3u);
    requestAllPoses(7); // as for another camera
    EXPECT_EQ(page->requests.size(), 3u);
    for (const auto& [tree, place] : places) {
        EXPECT_EQ(reader->places[tree].block, place.block);
        EXPECT_EQ(reader->places[tree].page, place.page);
    }
    requestAllPoses(8);
    EXPECT_NE(reader->places[0].page, page);
    EXPECT_EQ(reader->places[0].page->requests.size(), 3u);
}

TEST_F(PosePassGlTest, RequestsAfterTheFirstDrawOfAFrameArePosedToo) {
    startSimulation(smallForest(6));
    advanceSteps(10);
    for (std::size_t tree = 0; tree < 3; ++tree)
        reader->requestPose(0, tree);
    frame(0.0);
    for (std::size_t tree = 3; tree < 6; ++tree)
        reader->requestPose(0, tree); // in the same frame
    frame(0.04);
    expectPosesOfTheCpu(1e-3f);
}

TEST_F(PosePassGlTest, ManyTreesUseSeveralPages) {
    ForestDescription many = smallForest(1, 20.0f);
    many.species[0].tree.wood.levels = 1;
    many.species[0].tree.leaves.clustersPerBranch = 0;
    many.species[0].shapes = 1;
    many.trees.resize(PosePage::maxTrees + 100, many.trees[0]);
    for (std::size_t i = 0; i < many.trees.size(); ++i)
        many.trees[i].size.height = 4.0f + 0.3f * static_cast<float>(i % 7);
    startSimulation(many);
    advanceSteps(20);
    requestAllPoses(0);
    EXPECT_NE(reader->places[0].page, reader->places[many.trees.size() - 1].page);
    EXPECT_EQ(reader->places[0].page, reader->places[1].page);
    frame(0.0);
    expectPosesOfTheCpu(1e-3f);
    reader->places.clear();
    advanceSteps(1); // again, on reused pages
    requestAllPoses(1);
    frame(0.04);
    expectPosesOfTheCpu(1e-3f);
}

TEST_F(PosePassGlTest, ATreeMayFillMoreThanARow) {
    ForestDescription description = smallForest(3, 20.0f);
    description.species[0].tree.wood.levels = 6;
    description.species[0].tree.leaves.clustersPerBranch = 0;
    description.species[0].tree.wood.childrenPerBranch = 3;
    description.species[0].tree.wood.trunkUnits = 3;
    description.species[0].tree.wood.ringsPerBranch = 2;
    description.species[0].shapes = 1;
    startSimulation(description);
    ASSERT_GT(movingForest(*simulation).placed().unitCount(movingForest(*simulation).trees()[0]), 2048u);
    advanceSteps(20);
    requestAllPoses(0);
    frame(0.0);
    expectPosesOfTheCpu(1e-3f);
}

TEST_F(PosePassGlTest, AReleasedContextIsFilledAgain) {
    startSimulation(smallForest(4));
    advanceSteps(20);
    requestAllPoses(0);
    frame(0.0);
    passes->releaseGLObjects(nullptr);
    reader->read.clear();
    frame(0.04);
    expectPosesOfTheCpu(1e-3f);
}
