// SPDX-License-Identifier: MIT
// Random changes for OSGTREEWIND_SOAK_FRAMES frames (script/soak): no messages, finite numbers, flat memory.
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/controls/ForestHandler.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/nodes/TreeUnit.h>
#include <osgTreeWind/wind/FunctionWind.h>

#include <osg/MatrixTransform>
#include <osg/ShapeDrawable>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <numeric>
#include <random>
#include <sstream>

using namespace osgTreeWind;

namespace {

class SoakGlTest : public GlTest {
protected:
    SoakGlTest() {
        open(96, 72);
        viewer().setSceneData(root);
        viewer().getCamera()->setProjectionMatrixAsPerspective(40, 96.0 / 72.0, 0.5, 5000);
        viewer().getViewerStats()->collectStats("update", true);
        setForest(new Forest(smallForest(8)));
    }

    unsigned randomBelow(unsigned count) { return static_cast<unsigned>(random()) % count; }
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }

    void setForest(const osg::ref_ptr<Forest>& next) {
        root->removeChildren(0, root->getNumChildren());
        forest = next;
        handler = new ForestHandler(forest);
        transform = new osg::MatrixTransform;
        transform->addChild(forest);
        root->addChild(transform);
        root->addChild(handler->getOverlay());
    }

    Wind randomWind() {
        const glm::vec3 mean(uniform(-20.0, 20.0), uniform(-20.0, 20.0), 0.0);
        WindSource source;
        source.kind = static_cast<WindSource::Kind>(randomBelow(5));
        source.position = {uniform(-5.0, 15.0), uniform(-5.0, 15.0), uniform(0.0, 20.0)};
        source.velocity = {uniform(-9.0, 9.0), 0.0, 0.0};
        Wind wind;
        switch (randomBelow(5)) {
        case 0:
            return wind;
        case 1:
            wind = std::make_shared<UniformWind>(mean);
            wind.gusts.intensity = 0.2;
            return wind;
        case 2:
            wind = std::make_shared<UniformWind>(mean);
            wind.sources = {source};
            return wind;
        case 3:
            return std::make_shared<FunctionWind>(
                [mean](const glm::vec3&, double time) { return mean * static_cast<float>(std::sin(time)); });
        default:
            return std::make_shared<UniformWind>(mean);
        }
    }

    TreePlacement randomPlacement() {
        TreePlacement tree = smallForest(1).trees.front();
        tree.position = {uniform(-10.0, 20.0), uniform(-10.0, 20.0), uniform(-1.0, 1.0)};
        tree.size.height = static_cast<float>(uniform(1.0, 12.0));
        tree.leaves = static_cast<float>(uniform(0.0, 1.0));
        tree.openGrown = randomBelow(2) == 0;
        tree.seed = randomBelow(1000);
        return tree;
    }

    ForestDescription randomForest() {
        ForestDescription description = smallForest(static_cast<int>(randomBelow(12)));
        if (randomBelow(50) == 0)
            description.species.front() = *findSpecies("silver birch");
        if (randomBelow(3) == 0)
            description.law = static_cast<MotionLaw>(randomBelow(3));
        description.damage = description.law == MotionLaw::Modal && randomBelow(3) == 0;
        description.gain = static_cast<float>(uniform(0.0, 4.0));
        description.season = static_cast<float>(uniform(0.0, 4.0));
        description.wind = randomWind();
        description.canopy.source = randomBelow(3) == 0 ? CanopySource::Forest : CanopySource::None;
        description.drawing.tiers = randomBelow(4) > 0;
        description.drawing.budget = randomBelow(4) == 0 ? 5.0f : 0.0f;
        return description;
    }

    TreeId randomTree() {
        const std::vector<TreeId> trees = forest->getTrees();
        return trees.empty() ? TreeId(~0ull) : trees[randomBelow(static_cast<unsigned>(trees.size()))];
    }

    void followRandomBranch() {
        const TreeId tree = randomTree();
        const std::size_t units = forest->getUnits(tree).size();
        if (units == 0)
            return;
        const unsigned unit = randomBelow(static_cast<unsigned>(units));
        const Result<BranchTransform*> branch = forest->branch(tree, unit);
        if (branch && randomBelow(3) > 0)
            branch.value()->addChild(new osg::ShapeDrawable(new osg::Sphere(osg::Vec3(), 0.1f)));
        else
            forest->releaseBranch(tree, unit);
    }

    void pressRandomKey() {
        constexpr char keys[] = "0[]pn+-mgGdvbrahi";
        osg::ref_ptr<osgGA::GUIEventAdapter> event = new osgGA::GUIEventAdapter;
        event->setEventType(osgGA::GUIEventAdapter::KEYDOWN);
        const unsigned key = randomBelow(sizeof keys + 5);
        event->setKey(key < sizeof keys - 1 ? keys[key]
                                            : osgGA::GUIEventAdapter::KEY_Left + static_cast<int>(key % 6));
        handler->handle(*event, viewer());
        event->setEventType(osgGA::GUIEventAdapter::FRAME);
        event->setTime(time += 0.3);
        handler->handle(*event, viewer());
    }

    void writeAndReadForest() {
        ForestDescription description = forest->getSimulation().currentDescription();
        if (dynamic_cast<const FunctionWind*>(description.wind.field.get()))
            description.wind = nullptr;
        std::stringstream text;
        const Diagnostics problems = writeForest(description, text);
        ASSERT_TRUE(problems.empty() || problems.front().key == "wind") << problems.front().text();
        if (!problems.empty())
            return;
        const auto again = readForest(text);
        ASSERT_TRUE(again) << again.problems().front().text() << text.str();
        ASSERT_EQ(again.value().trees.size(), description.trees.size());
        EXPECT_TRUE(forest->setDescription(again.value()).empty());
    }

    void moveCamera() {
        const double distance = std::pow(10.0, uniform(0.5, 3.0)), turn = uniform(0.0, 6.28);
        viewer().getCamera()->setViewMatrixAsLookAt(
            {5.0 + distance * std::cos(turn), 3.0 + distance * std::sin(turn), uniform(0.5, 0.8 * distance)},
            {5.0, 3.0, 2.0}, osg::Z_AXIS);
    }

    void makeRandomChange() {
        const std::vector<std::function<void()>> all = {
            [&] {
                Wind wind = randomWind();
                wind.frame = static_cast<WindFrame>(randomBelow(2));
                EXPECT_TRUE(forest->setWind(wind).empty());
            },
            [&] { EXPECT_TRUE(forest->setSeason(static_cast<float>(uniform(0.0, 4.0))).empty()); },
            [&] {
                if (forest->getNumTrees() < 30)
                    static_cast<void>(forest->addTree(randomPlacement()).ok());
            },
            [&] { static_cast<void>(forest->removeTree(randomTree())); },
            [&] { static_cast<void>(forest->changeTree(randomTree(), randomPlacement())); },
            [&] { followRandomBranch(); },
            [&] { pressRandomKey(); },
            [&] { moveCamera(); },
            [&] { transform->setMatrix(osg::Matrix::rotate(uniform(0.0, 6.28), osg::Z_AXIS)); },
            [&] { time += randomBelow(2) == 0 ? 1e-4 : uniform(0.0, 20.0); },
            [&] {
                root->releaseGLObjects(randomBelow(2) == 0 ? context().getState() : nullptr);
                context().makeCurrent(); // OSG 3.6.5 takes the array that it drew last for still bound
                context().getState()->disableAllVertexArrays();
            },
            [&] { setForest(static_cast<Forest*>(forest->clone(osg::CopyOp::SHALLOW_COPY))); },
            [&] { EXPECT_TRUE(forest->setDescription(randomForest()).empty()); },
            [&] { setForest(new Forest(randomForest())); },
            [&] { writeAndReadForest(); },
        };
        all[randomBelow(static_cast<unsigned>(all.size()))]();
    }

    /// Memory of the process with a small forest, in place of the present one.
    std::size_t measureMemory() {
        setForest(new Forest(smallForest(8)));
        for (int i = 0; i < 20; ++i)
            frame(time += 1.0 / 60.0);
#ifdef __GLIBC__
        malloc_trim(0);
#endif
        return residentMemory();
    }

    std::mt19937 random{7};
    osg::ref_ptr<osg::Group> root = new osg::Group;
    osg::ref_ptr<osg::MatrixTransform> transform;
    osg::ref_ptr<Forest> forest;
    osg::ref_ptr<ForestHandler> handler;
    double time = 0.0;
};

} // namespace

TEST_F(SoakGlTest, RandomChangesForManyFrames) {
    const char* given = std::getenv("OSGTREEWIND_SOAK_FRAMES");
    const int frames = std::max(given ? std::atoi(given) : 400, 20), part = frames / 20;
    std::vector<std::size_t> memory; // OSG's caches vary by some 10 MB
    for (int i = 0; i < frames && !HasFailure(); ++i) {
        SCOPED_TRACE("frame " + std::to_string(i));
        if (randomBelow(4) == 0)
            makeRandomChange();
        frame(time += 1.0 / 60.0);
        if (i % part != 0)
            continue;
        for (const TreeId tree : forest->getTrees())
            for (const TreeUnit& unit : forest->getUnits(tree))
                ASSERT_TRUE(std::isfinite(unit.base.length()));
        memory.push_back(measureMemory());
        if (given)
            std::cout << "frame " << i << ": " << memory.back() / 1000000 << " MB" << std::endl;
    }
    if (frames >= 10000 && !HasFailure()) {
        const auto sumOf5 = [&](std::ptrdiff_t first) {
            return std::accumulate(memory.begin() + first, memory.begin() + first + 5, std::size_t(0));
        };
        EXPECT_LT(sumOf5(15), sumOf5(5) + 5 * keptMemory) << "means of the second and the last quarter";
    }
}
