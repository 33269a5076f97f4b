// SPDX-License-Identifier: MIT
// The frames of a wind, for forests at different places.
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>

#include <osg/CoordinateSystemNode>
#include <osg/MatrixTransform>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

using namespace osgTreeWind;

namespace {

constexpr float westerly = 12.0f; // m/s at 10 m

/// A steady wind toward a direction, uniform or with the logarithmic profile.
WindFieldPtr toward(const osg::Vec3d& direction, bool logarithmic) {
    WindSeries series;
    series.times = {0.0};
    series.velocities = {westerly * glm::vec3(direction.x(), direction.y(), direction.z())};
    if (logarithmic)
        series.profile = LogProfile{10.0f, 0.1f};
    return TimeSeriesWind::create(series).value();
}

/// The local frame of a place on a globe: x east, y north, z up.
osg::Matrixd onGlobe(double latitude, double longitude) {
    osg::Matrixd frame;
    osg::EllipsoidModel().computeLocalToWorldTransformFromLatLongHeight(
        osg::DegreesToRadians(latitude), osg::DegreesToRadians(longitude), 20.0, frame);
    return frame;
}

ForestDescription trees(const WindFieldPtr& wind) {
    ForestDescription description = smallForest(3);
    description.wind = {wind, WindFrame::Forest};
    return description;
}

/// The lean of the trees after two seconds at a place, in the axes of the forest.
std::vector<glm::vec2> leansAt(const osg::Matrixd& place, Forest& forest) {
    const osg::ref_ptr<osg::MatrixTransform> scene = new osg::MatrixTransform(place);
    scene->addChild(&forest);
    updateFrames(*scene, 1, 50);
    std::vector<glm::vec2> leans;
    for (std::size_t tree = 0; tree < forest.getNumTrees(); ++tree)
        leans.push_back(movingForest(forest.getSimulation()).modal()->lean(tree));
    return leans;
}

void expectSameLeans(const std::vector<glm::vec2>& found, const std::vector<glm::vec2>& expected,
                     const char* where) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t tree = 0; tree < found.size(); ++tree) {
        EXPECT_GT(expected[tree].x, 0.01f);
        EXPECT_LT(glm::distance(found[tree], expected[tree]), 0.01f * glm::length(expected[tree])) << where;
    }
}

struct Place {
    const char* name;
    osg::Matrixd matrix;
};
const Place places[] = {{"turned", osg::Matrixd::rotate(osg::PI_2, osg::Z_AXIS)},
                        {"on its side", osg::Matrixd::rotate(osg::PI_2, osg::X_AXIS)},
                        {"small", osg::Matrixd::scale(0.1, 0.1, 0.1)},
                        {"Iceland", onGlobe(64.0, -22.6)},
                        {"the equator", onGlobe(0.0, 30.0)}};

} // namespace

TEST(WindFrameTest, AForestWindMovesWithTheForest) {
    for (const bool logarithmic : {false, true}) {
        const WindFieldPtr wind = toward(osg::X_AXIS, logarithmic);
        const osg::ref_ptr<Forest> flat = new Forest(trees(wind));
        const std::vector<glm::vec2> expected = leansAt(osg::Matrixd(), *flat);
        for (const Place& place : places) {
            const osg::ref_ptr<Forest> forest = new Forest(trees(wind));
            expectSameLeans(leansAt(place.matrix, *forest), expected, place.name);
        }
    }
}

TEST(WindFrameTest, AGeocentricWindActsAsOnFlatGround) {
    for (const bool logarithmic : {false, true}) {
        const osg::ref_ptr<Forest> flat = new Forest(trees(toward(osg::X_AXIS, logarithmic)));
        const std::vector<glm::vec2> expected = leansAt(osg::Matrixd(), *flat);
        for (const auto& [latitude, longitude] : {std::pair(64.0, -22.6), {0.0, 30.0}, {-35.0, 149.0}}) {
            const osg::Matrixd place = onGlobe(latitude, longitude);
            const osg::Vec3d east = osg::Matrixd::transform3x3(osg::X_AXIS, place);
            const osg::ref_ptr<Forest> forest = new Forest(trees(nullptr));
            EXPECT_TRUE(forest->setWind({toward(east, logarithmic), WindFrame::Geocentric}).empty());
            expectSameLeans(leansAt(place, *forest), expected, "geocentric");
        }
    }
}

TEST(WindFrameTest, ASceneWindUsesTheAxesOfTheRoot) {
    const osg::ref_ptr<Forest> flat = new Forest(trees(toward(osg::X_AXIS, true)));
    const std::vector<glm::vec2> expected = leansAt(osg::Matrixd(), *flat);
    const osg::ref_ptr<Forest> turned = new Forest(trees(nullptr));
    EXPECT_TRUE(turned->setWind(toward(osg::Y_AXIS, true)).empty());
    EXPECT_EQ(turned->getWind().frame, WindFrame::Scene);
    expectSameLeans(leansAt(osg::Matrixd::rotate(osg::PI_2, osg::Z_AXIS), *turned), expected, "turned");
}

TEST(WindFrameTest, ACopyHasTheWindInTheSameFrameAndItsGusts) {
    const osg::ref_ptr<Forest> forest = new Forest(trees(nullptr));
    Wind wind(toward(osg::X_AXIS, false), WindFrame::Geocentric);
    wind.gusts.intensity = 0.3;
    EXPECT_TRUE(forest->setWind(wind).empty());
    const osg::ref_ptr<Forest> copy = new Forest(*forest);
    EXPECT_EQ(copy->getWind().frame, WindFrame::Geocentric);
    const Wind now = copy->getSimulation().currentDescription().wind;
    EXPECT_EQ(now.frame, WindFrame::Geocentric);
    EXPECT_EQ(now.gusts.intensity, 0.3);
    wind.gusts.intensity = 1.01;
    EXPECT_FALSE(forest->setWind(wind).empty());
    EXPECT_EQ(forest->getWind().gusts.intensity, 0.3) << "unchanged";
}

TEST(WindFrameTest, ACanopyDoesNotWeakenSourcesAtAnyPlace) {
    const auto leansUnderAJet = [](const osg::Matrixd& place) {
        const osg::Vec3d mouth = osg::Vec3d(-6.0, 0.0, 4.0) * place,
                         way = osg::Matrixd::transform3x3(osg::X_AXIS, place);
        WindSource jet;
        jet.kind = WindSource::Kind::Jet;
        jet.position = {mouth.x(), mouth.y(), mouth.z()};
        jet.radius = 2.0;
        jet.speed = 30.0;
        jet.turbulence = 0.0;
        jet.toward = static_cast<float>(std::atan2(way.x(), way.y()));
        ForestDescription description = smallForest(3);
        description.wind = nullptr;
        description.canopy.source = CanopySource::Given;
        const osg::ref_ptr<Forest> forest = new Forest(description);
        Wind wind(std::make_shared<UniformWind>(glm::vec3(0.0f, 0.0f, 0.0f)));
        wind.sources = {jet};
        EXPECT_TRUE(forest->setWind(wind).empty());
        return leansAt(place, *forest);
    };
    const std::vector<glm::vec2> expected = leansUnderAJet(osg::Matrixd());
    expectSameLeans(leansUnderAJet(osg::Matrixd::translate(500.0, 0.0, 0.0)), expected, "500 m to the east");
    expectSameLeans(leansUnderAJet(osg::Matrixd::rotate(osg::PI_2, osg::Z_AXIS) *
                                   osg::Matrixd::translate(40.0, 90.0, 0.0)),
                    expected, "turned");
}
