// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/WindCache.h>

#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace osgTreeWind {

namespace {

std::shared_ptr<const Wind> blowing(float x, float y) {
    return std::make_shared<const Wind>(std::make_shared<UniformWind>(glm::vec3(x, y, 0)));
}

/// The wind at the origin.
glm::vec3 velocityOf(const WindFieldPtr& field) {
    return field->velocity({0, 0, 0}, 0.0);
}

} // namespace

TEST(WindCache, TransformsTheOpenWindToTheForest) {
    WindCache cache{CanopySettings()};
    const auto east = blowing(3, 0), north = blowing(0, 3);
    EXPECT_EQ(cache.openField(std::make_shared<const Wind>()), nullptr) << "calm";
    EXPECT_EQ(cache.openField(east), east->field) << "the same field";
    cache.setForestToScene(glm::rotate(glm::dmat4(1.0), glm::half_pi<double>(), glm::dvec3(0, 0, 1)));
    const WindFieldPtr here = cache.openField(east);
    EXPECT_LT(glm::distance(velocityOf(here), glm::vec3(0, -3, 0)), 1e-6f);
    EXPECT_EQ(cache.openField(east), here) << "cached";
    EXPECT_LT(glm::distance(velocityOf(cache.openField(north)), glm::vec3(3, 0, 0)), 1e-6f);
    cache.reset();
    EXPECT_LT(glm::distance(velocityOf(cache.openField(north)), glm::vec3(3, 0, 0)), 1e-6f)
        << "the place is kept";
    cache.setForestToScene(glm::dmat4(1.0));
    EXPECT_EQ(cache.openField(north), north->field);
}

TEST(WindCache, RebuildsTheWindAtTheTreesOnlyIfSomethingChanges) {
    CanopySettings given;
    given.source = CanopySource::Given;
    const PlacedForest forest{ForestDescription()};
    WindCache cache(given);
    const auto east = blowing(3, 0), stronger = blowing(3.2f, 0), other = blowing(9, 0);
    const WindFieldPtr first = cache.fieldAtTrees(east, forest, 0.0);
    const auto flow = cache.flow();
    EXPECT_EQ(cache.fieldAtTrees(east, forest, 1.0), first);
    EXPECT_NE(cache.fieldAtTrees(stronger, forest, 1.0), first);
    EXPECT_EQ(cache.flow(), flow) << "about the same mean wind";
    cache.fieldAtTrees(other, forest, 1.0);
    EXPECT_NE(cache.flow(), flow);
    cache.setCanopy(CanopySettings());
    EXPECT_EQ(cache.flow(), nullptr);
    EXPECT_EQ(cache.fieldAtTrees(other, forest, 2.0), other->field);
}

} // namespace osgTreeWind
