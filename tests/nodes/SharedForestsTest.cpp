// SPDX-License-Identifier: MIT
// Forests of the same trees share their parts, for hosts that read each object by itself.
#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>
#include <tests/nodes/ForestFixtures.h>

#include <osg/Texture2D>

#include <gtest/gtest.h>

#include <set>
#include <thread>

using namespace osgTreeWind;

namespace {

using Forests = std::vector<osg::ref_ptr<Forest>>;

const InstancedResources& resourcesOf(const Forest& forest) {
    return instancedTrees(*forest.getInstanced()).resources();
}

/// All parts that take time to make or much memory.
std::set<const void*> partsOf(const Forest& forest) {
    std::set<const void*> parts;
    for (const auto& model : movingForest(forest.getSimulation()).models())
        parts.insert(model.get());
    for (std::size_t tree = 0; tree < forest.getNumTrees(); ++tree)
        parts.insert(&movingForest(forest.getSimulation()).modal()->archetype(tree));
    for (osg::Object* object : resourcesOf(forest).glObjects()) {
        if (osg::StateSet* state = object->asStateSet()) {
            for (const auto& [key, attribute] : state->getAttributeList())
                parts.insert(attribute.first.get());
            for (unsigned unit = 0; unit < state->getTextureAttributeList().size(); ++unit)
                parts.insert(state->getTextureAttribute(unit, osg::StateAttribute::TEXTURE));
        } else {
            parts.insert(object);
        }
    }
    return parts;
}

Species plainSpecies(const std::string& name) {
    Species species = smallSpecies();
    species.name = name;
    return species;
}

} // namespace

TEST(SharedForests, ShareAllParts) {
    const osg::ref_ptr<Forest> one = new Forest(smallForest(4));
    const std::set<const void*> parts = partsOf(*one);
    EXPECT_GE(parts.size(), 20u);
    Forests held;
    for (int i = 0; i < 50; ++i) {
        held.push_back(new Forest(smallForest(4)));
        ASSERT_EQ(partsOf(*held.back()), parts) << i;
    }
}

TEST(SharedForests, DoNotShareDifferentLooksOrMotion) {
    ForestDescription description = smallForest(2);
    const osg::ref_ptr<Forest> one = new Forest(description);
    description.species[0].appearance.bark.r += 0.125f;
    const osg::ref_ptr<Forest> brown = new Forest(description);
    EXPECT_EQ(movingForest(one->getSimulation()).models(), movingForest(brown->getSimulation()).models());
    EXPECT_NE(resourcesOf(*one).models[0]->impostor(Tier::Impostor),
              resourcesOf(*brown).models[0]->impostor(Tier::Impostor));
    EXPECT_EQ(&resourcesOf(*one).models[0]->meshes(), &resourcesOf(*brown).models[0]->meshes());
    description.species[0].wood.density *= 2.0f;
    const osg::ref_ptr<Forest> heavy = new Forest(description);
    EXPECT_NE(&movingForest(one->getSimulation()).modal()->archetype(0),
              &movingForest(heavy->getSimulation()).modal()->archetype(0));
}

TEST(SharedForests, ShareRegardlessOfTheSpeciesName) {
    ForestDescription description = smallForest(2);
    const osg::ref_ptr<Forest> one = new Forest(description);
    description.species[0] = plainSpecies("other");
    EXPECT_EQ(partsOf(*one), partsOf(*osg::ref_ptr<Forest>(new Forest(description))));
}

TEST(SharedForests, DoNotShareTheHostsGeometry) {
    const osg::ref_ptr<Forest> one = new Forest(smallForest(2)), other = new Forest(smallForest(2));
    one->getInstanced()->setGeometry(0, new osg::Geometry, nullptr);
    EXPECT_TRUE(resourcesOf(*one).models[0]->usesHostGeometry());
    EXPECT_NE(resourcesOf(*one).models[0]->hostBark(), nullptr);
    EXPECT_FALSE(resourcesOf(*other).models[0]->usesHostGeometry());
    EXPECT_EQ(resourcesOf(*other).models[0]->hostBark(), nullptr);
}

TEST(SharedForests, ShapesGetMeshesWithTheirFirstTree) {
    ForestDescription description = smallForest(1);
    description.species[0].shapes = 2;
    const osg::ref_ptr<Forest> forest = new Forest(description);
    EXPECT_NE(resourcesOf(*forest).models[0], nullptr);
    EXPECT_EQ(resourcesOf(*forest).models[1], nullptr);
    TreePlacement tree = description.trees[0];
    tree.seed = 1;
    EXPECT_TRUE(forest->addTree(tree));
    ASSERT_NE(resourcesOf(*forest).models[1], nullptr);
    EXPECT_NE(resourcesOf(*forest).models[1]->impostor(Tier::Impostor), nullptr);
}

TEST(SharedForests, HaveTheirOwnSeasons) {
    const osg::ref_ptr<Forest> one = new Forest(smallForest(2)), other = new Forest(smallForest(2));
    EXPECT_TRUE(one->setSeason(2.0f).empty());
    EXPECT_NE(resourcesOf(*one).looks[0].leaves, resourcesOf(*other).looks[0].leaves);
    EXPECT_EQ(other->getSeason(), osg::ref_ptr<Forest>(new Forest(smallForest(2)))->getSeason());
}

TEST(SharedForests, KeepNothingAfterTheLastForest) {
    std::weak_ptr<const TreeModel> model;
    osg::observer_ptr<osg::Geometry> bark;
    {
        const osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
        model = movingForest(forest->getSimulation()).models()[0];
        bark = resourcesOf(*forest).models[0]->meshes().bark.geometry;
    }
    EXPECT_TRUE(model.expired());
    EXPECT_FALSE(bark.valid());
}

TEST(SharedForests, ShareUnderABranchLawToo) {
    ForestDescription description = smallForest(2);
    description.law = MotionLaw::ThesisSmooth;
    const osg::ref_ptr<Forest> one = new Forest(description), other = new Forest(description);
    EXPECT_EQ(movingForest(one->getSimulation()).models(), movingForest(other->getSimulation()).models());
    EXPECT_EQ(branchwiseTrees(*one->getBranchwise()).buffers(0).skin(),
              branchwiseTrees(*other->getBranchwise()).buffers(0).skin());
}

TEST(SharedForests, ParallelLoadsMakeEachPartOnce) {
    Forests made(8);
    std::vector<std::thread> threads;
    for (osg::ref_ptr<Forest>& forest : made)
        threads.emplace_back([&forest] { forest = new Forest(smallForest(4)); });
    for (std::thread& thread : threads)
        thread.join();
    for (const osg::ref_ptr<Forest>& forest : made)
        EXPECT_EQ(partsOf(*forest), partsOf(*made.front()));
}
