// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/drawing/instanced/MeshParts.h>
#include <osgTreeWind/drawing/instanced/TreeGeometry.h>
#include <osgTreeWind/drawing/instanced/TreeHit.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/laws/PosedPoints.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/TriangleFunctor>

#include <numeric>

using namespace osgTreeWind;

namespace {

const char* const whiteFragments = "out vec4 color;\nvoid main() { color = vec4(1.0); }";

/// Draws white, independent of lights.
osg::ref_ptr<osg::StateSet> silhouette(const char* vertexShader) {
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(makeProgram("white", shaderText(vertexShader), whiteFragments));
    return state;
}

struct Triangles {
    void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, bool = false) {
        for (const osg::Vec3& corner : {a, b, c})
            corners->push_back(corner);
    }
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
};

osg::ref_ptr<osg::Geometry> whiteTriangles(osg::Vec3Array* corners) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setVertexArray(corners);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<int>(corners->size())));
    geometry->getOrCreateStateSet()->setAttributeAndModes(makeProgram(
        "white", "void main() { gl_Position = osg_ProjectionMatrix * (osg_ModelViewMatrix * osg_Vertex); }",
        whiteFragments));
    return geometry;
}

/// All trees in their current pose, computed on the CPU.
osg::ref_ptr<osg::Node> posedByCpu(const Forest& forest) {
    osg::TriangleFunctor<Triangles> triangles;
    for (std::size_t tree = 0; tree < movingForest(forest.getSimulation()).trees().size(); ++tree)
        osg::ref_ptr<TreeHit>(new TreeHit(forest.getSimulation(), TreeId(tree)))->accept(triangles);
    return whiteTriangles(triangles.corners);
}

/// Trees of two species with different shapes and sizes. One has a heading of 180 degrees.
ForestDescription mixed(float speed) {
    ForestDescription description = smallForest(8, speed);
    description.species.push_back(Species());
    description.species[1].tree.wood.levels = 3;
    description.species[1].wood.streamlining = 0.9f;
    description.species[1].leaf.maxDownwind = 1.0f;
    for (std::size_t i = 0; i < 8; i += 3)
        description.trees[i].species = 1;
    description.trees[2].heading = 3.14159265f;
    description.trees[5].size.crownWidth = 9.0f;
    description.drawing.tiers = false;
    return description;
}

/// Share of differing pixels.
double differing(const osg::Image& a, const osg::Image& b) {
    int pixels = 0;
    for (int i = 0; i < a.s() * a.t(); ++i)
        pixels += std::abs(int(a.data()[4 * i]) - int(b.data()[4 * i])) > 64;
    return pixels / double(a.s() * a.t());
}

class InstancedTreesGlTest : public GlTest {
protected:
    static constexpr int width = 320, height = 240;

    /// Opens a view of the two rows of trees from the south.
    void look(osg::Node* scene) {
        reopen(width, height);
        viewer().setSceneData(scene);
        osg::Camera& camera = *viewer().getCamera();
        camera.setProjectionMatrixAsPerspective(40, double(width) / height, 1, 200);
        camera.setViewMatrixAsLookAt(osg::Vec3(4.5f, -16, 6), osg::Vec3(4.5f, 0, 3), osg::Z_AXIS);
    }
    osg::ref_ptr<osg::Image> run(int first, int last) {
        for (int i = first; i <= last; ++i)
            frame(i / 25.0);
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }
    osg::ref_ptr<osg::Image> picture(osg::Node* scene, int frames) {
        look(scene);
        return run(0, frames - 1);
    }
};

void drawWhite(Forest& forest) {
    for (std::size_t species = 0; species < forest.getDescription().species.size(); ++species) {
        forest.getInstanced()->setBarkState(species, silhouette("instance_bark.vert"));
        forest.getInstanced()->setLeafState(species, silhouette("instance_leaf.vert"));
    }
}

} // namespace

TEST_F(InstancedTreesGlTest, DrawsTreesAsTheCpuPosesThem) {
    const osg::Matrix place = osg::Matrix::rotate(0.2, osg::Z_AXIS) * osg::Matrix::translate(0.5, 2.0, -0.4);
    ForestDescription description = mixed(20.0f);
    for (Species& species : description.species)
        species.leaf.tremble = 0.0f; // the CPU pose does not include it
    osg::ref_ptr<Forest> forest = new Forest(description);
    drawWhite(*forest);
    osg::ref_ptr<osg::MatrixTransform> scene = new osg::MatrixTransform(place),
                                       cpu = new osg::MatrixTransform(place),
                                       rest = new osg::MatrixTransform(place);
    scene->addChild(forest);
    rest->addChild(posedByCpu(*forest));
    osg::ref_ptr<osg::Image> gpu = picture(scene, 40);
    cpu->addChild(posedByCpu(*forest));
    osg::ref_ptr<osg::Image> expected = picture(cpu, 1);
    EXPECT_GT(covered(*expected), 0.1);
    EXPECT_LT(differing(*gpu, *expected), 0.001);
    EXPECT_GT(differing(*gpu, *picture(rest, 1)), 0.02) << "the test is void: the trees have not moved";
}

TEST_F(InstancedTreesGlTest, AttachedNodesFollowBranchesInTheSameFrame) {
    ForestDescription description = mixed(20.0f);
    for (Species& species : description.species)
        species.tree.leaves.clustersPerBranch = 0;
    osg::ref_ptr<Forest> drawn = new Forest(description), followed = new Forest(description);
    drawWhite(*drawn);
    const ForestSimulation& simulation = followed->getSimulation();
    for (std::size_t tree = 0; tree < movingForest(simulation).trees().size(); ++tree) {
        const PlacedTree& placed = movingForest(simulation).trees()[tree];
        const BranchSkin& skin = movingForest(simulation).placed().modelOf(placed).skin();
        const std::size_t units = movingForest(simulation).placed().unitCount(placed);
        for (unsigned unit = 0; unit < units; ++unit) {
            osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
            for (const auto index : skin.indices) {
                const SkinVertex& vertex = skin.vertices[index];
                if (static_cast<unsigned>(vertex.unit + 0.5f) == unit)
                    corners->push_back(toOsg(posedSkinPoint(vertex, placed.scale, UnitPose())));
            }
            followed->branch(TreeId(tree), unit).value()->addChild(whiteTriangles(corners));
        }
    }
    instancedTrees(*followed->getInstanced()).setNodeMask(0);
    osg::ref_ptr<osg::Image> trees = picture(drawn, 30), things = picture(followed, 30);
    EXPECT_GT(covered(*trees), 0.01);
    EXPECT_LT(differing(*trees, *things), 0.002); // trees widen wood thinner than a pixel
}

TEST_F(InstancedTreesGlTest, ColoursDoNotDependOnOtherTrees) {
    ForestDescription all = smallForest(4, 0.0f), without = all;
    without.trees.erase(without.trees.begin() + 1);
    osg::ref_ptr<Forest> forest = new Forest(all);
    osg::ref_ptr<osg::Image> fewer = picture(new Forest(without), 1);
    look(forest);
    osg::ref_ptr<osg::Image> whole = run(0, 0);
    EXPECT_GT(difference(*whole, *fewer).mean, 0.3);
    ASSERT_TRUE(forest->removeTree(TreeId(1)).empty());
    EXPECT_EQ(difference(*run(1, 1), *fewer).mean, 0.0);
    const TreeId again = forest->addTree(all.trees[1]).value();
    EXPECT_EQ(difference(*run(2, 2), *whole).mean, 0.0);
    TreePlacement behind = all.trees[1];
    behind.position.y = -60.0;
    ASSERT_TRUE(forest->changeTree(again, behind).empty());
    EXPECT_EQ(difference(*run(3, 3), *fewer).mean, 0.0);
}

TEST_F(InstancedTreesGlTest, DrawsTheSameWithVertexArrayObjects) {
    osg::ref_ptr<osg::Image> plain = picture(new Forest(smallForest(6)), 4);
    osg::DisplaySettings& settings = *osg::DisplaySettings::instance();
    const auto former = settings.getVertexBufferHint();
    settings.setVertexBufferHint(osg::DisplaySettings::VERTEX_ARRAY_OBJECT);
    osg::ref_ptr<osg::Image> objects = picture(new Forest(smallForest(6)), 4);
    settings.setVertexBufferHint(former);
    EXPECT_GT(covered(*plain), 0.05);
    EXPECT_EQ(difference(*plain, *objects).mean, 0.0);
}

TEST_F(InstancedTreesGlTest, CopyDrawsTheSameTreesInItsOwnWind) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(4));
    osg::ref_ptr<osg::Image> still = picture(new Forest(smallForest(4, 0.0f)), 10);
    osg::ref_ptr<osg::Image> blown = picture(forest, 10);
    osg::ref_ptr<Forest> copy = osg::clone(forest.get());
    EXPECT_TRUE(copy->setWind(nullptr).empty());
    EXPECT_EQ(difference(*picture(copy, 10), *still).mean, 0.0);
    EXPECT_GT(difference(*blown, *still).mean, 0.3);
}

TEST_F(InstancedTreesGlTest, HostTextureSetsTheBrightnessOfLeaves) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(4, 0.0f));
    osg::ref_ptr<osg::Image> plain = picture(forest, 1);
    osg::ref_ptr<osg::Image> dark = new osg::Image;
    dark->allocateImage(1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    const unsigned char texel[4] = {0, 128, 0, 255}; // LeafTexels.h
    std::copy(texel, texel + 4, dark->data());
    osg::ref_ptr<osg::StateSet> own = new osg::StateSet;
    own->setTextureAttribute(0, new osg::Texture2D(dark));
    forest->getInstanced()->setLeafState(0, own);
    osg::ref_ptr<osg::Image> painted = run(1, 1);
    double greens[2] = {0, 0};
    for (int i = 0; i < width * height; ++i) {
        greens[0] += plain->data()[4 * i + 1];
        greens[1] += painted->data()[4 * i + 1];
    }
    EXPECT_LT(greens[1], 0.4 * greens[0]);
    forest->getInstanced()->setLeafState(0, nullptr);
    EXPECT_EQ(difference(*run(2, 2), *plain).mean, 0.0);
}

TEST_F(InstancedTreesGlTest, HostProgramReplacesTheBuiltInOne) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(4));
    osg::ref_ptr<osg::Image> plain = picture(forest, 2);
    forest->getInstanced()->setBarkState(0, silhouette("instance_bark.vert"));
    osg::ref_ptr<osg::Image> painted = run(2, 2);
    int before = 0, after = 0;
    for (int i = 0; i < width * height; ++i) {
        before += plain->data()[4 * i + 2] == 255;
        after += painted->data()[4 * i + 2] == 255;
    }
    EXPECT_EQ(before, 0);
    EXPECT_GT(after, 100) << "white bark";
    EXPECT_FALSE(forest->getInstanced()->setBarkState(7, silhouette("instance_bark.vert")))
        << "no such species";
}

TEST_F(InstancedTreesGlTest, OverriddenProgramAboveDoesNotAffectTrees) {
    for (const MotionLaw law : {MotionLaw::Modal, MotionLaw::ThesisSmooth}) {
        ForestDescription description = smallForest(4);
        description.law = law;
        osg::ref_ptr<osg::Group> host = new osg::Group;
        host->addChild(new Forest(description));
        osg::ref_ptr<osg::Program> program = new osg::Program;
        program->addShader(
            new osg::Shader(osg::Shader::FRAGMENT, "void main() { gl_FragColor = vec4(1, 0, 0, 1); }"));
        host->getOrCreateStateSet()->setAttributeAndModes(program, osg::StateAttribute::ON |
                                                                       osg::StateAttribute::OVERRIDE);
        EXPECT_EQ(difference(*picture(host, 3), *picture(new Forest(description), 3)).mean, 0.0)
            << static_cast<int>(law);
    }
}

TEST_F(InstancedTreesGlTest, HostGeometryMovesLikeTheBuiltInOne) {
    ForestDescription description = smallForest(4);
    description.drawing.tiers = false;
    osg::ref_ptr<Forest> forest = new Forest(description), plain = new Forest(description);
    const SharedModels& models = movingForest(forest->getSimulation()).models();
    for (std::size_t model = 0; model < models.size(); ++model) {
        const TreeModel& shape = *models[model];
        const CrownShade crown(shape.leaves, shape.leafMesh, leafCoverage(LeafForm::Blade));
        forest->getInstanced()->setGeometry(
            model, makeSkinGeometry(shape.skin(), shape.skeleton, crown),
            makeLeafGeometry(shape.leaves, shape.skeleton, shape.leafMesh, crown));
    }
    EXPECT_LT(difference(*picture(forest, 20), *picture(plain, 20)).mean, 0.001) << "built-in bark is packed";
    look(forest);
    for (std::size_t model = 0; model < models.size(); ++model)
        forest->getInstanced()->setGeometry(model, nullptr, nullptr);
    EXPECT_EQ(covered(*run(0, 1)), 0.0);
}

TEST_F(InstancedTreesGlTest, BarkIsMadeAgainForContextsThatLackIt) {
    const osg::ref_ptr<Forest> forest = new Forest(smallForest(4));
    const osg::ref_ptr<osg::Image> first = picture(forest, 1);
    const InstancedResources& resources = instancedTrees(*forest->getInstanced()).resources();
    for (const osg::ref_ptr<ModelResources>& model : resources.models)
        if (model) {
            const osg::Geometry& bark = *model->meshes().bark.geometry;
            EXPECT_EQ(bark.getVertexAttribArray(barkPlaceLocation)->getTotalDataSize(), 0u)
                << "OpenGL has it";
            EXPECT_EQ(bark.getPrimitiveSet(0)->getTotalDataSize(), 0u);
        }
    forest->releaseGLObjects();
    EXPECT_EQ(difference(*first, *run(0, 0)).mean, 0.0) << "after a release";
    EXPECT_EQ(difference(*first, *picture(forest, 1)).mean, 0.0) << "in another context";
}

TEST_F(InstancedTreesGlTest, DoesNotChangeOtherDrawings) { // passes restore the OpenGL state
    const auto cube = [] {
        osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
        for (const osg::Vec3 corner : {osg::Vec3(3, -2, 0), osg::Vec3(7, -2, 0), osg::Vec3(5, -2, 5)})
            corners->push_back(corner);
        osg::ref_ptr<osg::Geometry> geometry = whiteTriangles(corners);
        geometry->getOrCreateStateSet()->setMode(GL_BLEND, osg::StateAttribute::ON);
        geometry->getOrCreateStateSet()->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
        osg::ref_ptr<osg::Vec4Array> colour = new osg::Vec4Array;
        colour->push_back(osg::Vec4(1, 0.5f, 0.2f, 0.5f));
        geometry->setColorArray(colour, osg::Array::BIND_OVERALL);
        return geometry;
    };
    osg::ref_ptr<osg::Group> with = new osg::Group, without = new osg::Group;
    with->addChild(cube());
    without->addChild(cube());
    ForestDescription away = smallForest(4);
    for (TreePlacement& tree : away.trees)
        tree.position.x += 60.0; // outside the view, but not culled
    osg::ref_ptr<Forest> forest = new Forest(away);
    with->addChild(forest);
    with->setCullingActive(false);
    osg::ref_ptr<osg::Image> alone = picture(without, 3);
    look(with);
    viewer().getCamera()->setCullingMode(osg::CullSettings::NO_CULLING);
    osg::ref_ptr<osg::Image> together = run(0, 2);
    const auto listed = instancedTrees(*forest->getInstanced()).treesByTier();
    EXPECT_GT(std::accumulate(listed.begin(), listed.begin() + branchTiers, std::size_t{0}), 0u);
    EXPECT_GT(covered(*alone), 0.02);
    EXPECT_EQ(difference(*alone, *together).mean, 0.0);
}
