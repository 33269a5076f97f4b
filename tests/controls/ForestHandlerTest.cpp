// SPDX-License-Identifier: MIT
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/controls/ForestHandler.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/TreeUnit.h>
#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <osg/ApplicationUsage>
#include <osg/MatrixTransform>
#include <osgGA/GUIActionAdapter>
#include <osgText/Text>
#include <osgUtil/UpdateVisitor>
#include <osgViewer/View>

#include <gtest/gtest.h>

#include <set>

using namespace osgTreeWind;
using Event = osgGA::GUIEventAdapter;

namespace {

/// Sends keys and clicks to a handler, without drawing.
class ForestHandlerTest : public testing::Test {
protected:
    explicit ForestHandlerTest(ForestDescription description = smallForest(3))
        : forest(new Forest(std::move(description))), handler(new ForestHandler(forest)) {
        view->setSceneData(forest);
        view->getCamera()->setViewport(0, 0, 640, 480);
        view->getCamera()->setProjectionMatrixAsPerspective(40.0, 640.0 / 480.0, 0.1, 1000.0);
        view->getCamera()->setViewMatrixAsLookAt({0.0, -20.0, 2.5}, {0.0, 0.0, 2.5}, osg::Z_AXIS);
        view->setFrameStamp(new osg::FrameStamp);
    }
    bool press(int key) {
        osg::ref_ptr<Event> event = new Event;
        event->setEventType(Event::KEYDOWN);
        event->setKey(key);
        return handler->handle(*event, *view);
    }
    void click(float x, float y, float draggedBy = 0.0f) {
        for (const Event::EventType type : {Event::PUSH, Event::RELEASE}) {
            osg::ref_ptr<Event> event = new Event;
            event->setEventType(type);
            event->setButton(Event::LEFT_MOUSE_BUTTON);
            event->setInputRange(0.0f, 0.0f, 640.0f, 480.0f);
            event->setX(x + (type == Event::RELEASE ? draggedBy : 0.0f));
            event->setY(y);
            handler->handle(*event, *view);
        }
    }
    void runFrame(double simulationTime) {
        view->getFrameStamp()->setSimulationTime(simulationTime);
        overlayText();
    }
    /// Runs a frame event. @return the texts of the overlay.
    std::string overlayText() {
        osg::ref_ptr<Event> event = new Event;
        event->setEventType(Event::FRAME);
        event->setTime(_now += 1.0);
        handler->handle(*event, *view);
        std::string text;
        const osg::Group& overlay = *handler->getOverlay()->asGroup();
        for (unsigned i = 0; i < overlay.getNumChildren(); ++i)
            text +=
                static_cast<const osgText::Text*>(overlay.getChild(i))->getText().createUTF8EncodedString();
        return text;
    }
    bool shows(const std::string& words) { return overlayText().find(words) != std::string::npos; }

    osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
    osg::ref_ptr<Forest> forest;
    osg::ref_ptr<ForestHandler> handler;

private:
    double _now = 0.0;
};

TEST_F(ForestHandlerTest, ArrowKeysSteerTheWind) {
    ASSERT_TRUE(shows("wind    10.0 m/s from 270\xc2\xb0, gusts 0 %")) << overlayText();
    EXPECT_TRUE(press(Event::KEY_Up));
    EXPECT_TRUE(press(Event::KEY_Right));
    const auto wind = std::dynamic_pointer_cast<const UniformWind>(forest->getWind().field);
    ASSERT_TRUE(wind);
    EXPECT_NEAR(wind->velocity().x, 11.0 * std::cos(osg::DegreesToRadians(15.0)), 1e-4);
    EXPECT_NEAR(wind->velocity().y, -11.0 * std::sin(osg::DegreesToRadians(15.0)), 1e-4);
    EXPECT_TRUE(shows("11.0 m/s from 285\xc2\xb0"));
    press(Event::KEY_Page_Up);
    EXPECT_TRUE(shows("gusts 5 %"));
    press('0');
    EXPECT_TRUE(shows("10.0 m/s from 270\xc2\xb0, gusts 0 %"));
}

TEST_F(ForestHandlerTest, AWindThatDroppedToZeroKeepsItsDirection) {
    press(Event::KEY_Right);
    for (int i = 0; i < 12; ++i)
        press(Event::KEY_Down);
    EXPECT_TRUE(shows("wind    calm"));
    EXPECT_TRUE(forest->getWind().isCalm());
    press(Event::KEY_Up);
    EXPECT_TRUE(shows("1.0 m/s from 285\xc2\xb0"));
}

TEST_F(ForestHandlerTest, SteeringStartsFromTheHostsWind) {
    press(Event::KEY_Up);
    EXPECT_TRUE(forest
                    ->setWind(std::make_shared<FunctionWind>(
                        [](const glm::vec3&, double) { return glm::vec3(4, 0, 0); }))
                    .empty());
    press(Event::KEY_Down);
    EXPECT_NEAR(asField(forest->getWind())->velocity({}, 0.0).x, 3.6f, 1e-5f);
    EXPECT_TRUE(shows("of the host, times 0.9"));
    press(Event::KEY_Page_Up);
    EXPECT_TRUE(shows("of the host, times 0.9, gusts 5 %"));
    EXPECT_NE(asField(forest->getWind())->velocity({}, 0.0).x, 3.6f);
}

TEST_F(ForestHandlerTest, BracketKeysChangeTheSeason) {
    ASSERT_TRUE(shows("season  6 August"));
    for (int i = 0; i < 10; ++i)
        press(']');
    EXPECT_NEAR(forest->getSeason(), midautumn, 1e-5f);
    EXPECT_TRUE(shows("5 November"));
    for (int i = 0; i < 10; ++i)
        press(']');
    EXPECT_TRUE(shows("4 February")) << "past the end of the year";
    press('[');
    EXPECT_TRUE(shows("26 January"));
}

TEST_F(ForestHandlerTest, TimePausesStepsAndRuns) {
    EXPECT_EQ(handler->simulationTime(100.0), 0.0) << "the clock starts at 0";
    EXPECT_EQ(handler->simulationTime(101.0), 1.0);
    for (const double nonsense : {double(NAN), double(INFINITY), -1e300, 1e300})
        EXPECT_EQ(handler->simulationTime(nonsense), 1.0);
    press('+');
    EXPECT_EQ(handler->simulationTime(102.0), 3.0);
    EXPECT_TRUE(shows("x 2"));
    press('p');
    EXPECT_EQ(handler->simulationTime(110.0), 3.0);
    EXPECT_TRUE(shows("paused"));
    press('n');
    EXPECT_NEAR(handler->simulationTime(111.0), 3.0 + 1.0 / 30.0, 1e-12);
    EXPECT_NEAR(handler->simulationTime(112.0), 3.0 + 1.0 / 30.0, 1e-12);
    press('p');
    press('-');
    EXPECT_NEAR(handler->simulationTime(113.0), 4.0 + 1.0 / 30.0, 1e-12);
    EXPECT_NEAR(handler->simulationTime(1.0), 4.0 + 1.0 / 30.0, 1e-12) << "a clock that was set back";
}

TEST_F(ForestHandlerTest, ChangesTheLawInTheSameWind) {
    press(Event::KEY_Up);
    const WindFieldPtr wind = forest->getWind().field;
    std::set<MotionLaw> seen;
    for (int i = 0; i < 3; ++i) {
        seen.insert(forest->getDescription().law);
        press('m');
    }
    EXPECT_EQ(seen.size(), 3u);
    EXPECT_EQ(forest->getDescription().law, MotionLaw::Modal);
    EXPECT_EQ(forest->getNumTrees(), 3u);
    EXPECT_EQ(forest->getWind().field, wind);
    press('G');
    press('d');
    EXPECT_EQ(forest->getDescription().gain, 2.0f);
    EXPECT_TRUE(forest->getDescription().damage);
    EXPECT_TRUE(shows("gain 2, with damage"));
    press('b');
    EXPECT_EQ(forest->getDescription().drawing.budget, 33.0f);
    EXPECT_TRUE(shows("with damage, budget 33 ms"));
    press('b');
    EXPECT_EQ(forest->getDescription().drawing.budget, 0.0f);
}

TEST_F(ForestHandlerTest, ReportsWhatALawCannotDo) {
    press('d');
    press('m'); // branch laws do not support damage
    EXPECT_EQ(forest->getDescription().law, MotionLaw::Modal);
    EXPECT_TRUE(shows("\nerror   ")) << overlayText();
}

TEST_F(ForestHandlerTest, AClickDescribesTheTree) {
    const osg::Vec3d foot(0.0, 0.0, 0.0), screen = (foot + osg::Vec3d(0.0, 0.0, 1.0)) *
                                                   view->getCamera()->getViewMatrix() *
                                                   view->getCamera()->getProjectionMatrix();
    const auto x = static_cast<float>(320.0 * (1.0 + screen.x())),
               y = static_cast<float>(240.0 * (1.0 + screen.y()));
    click(x, y);
    ASSERT_EQ(handler->getTree(), forest->getTrees()[0]);
    EXPECT_LT(handler->getUnit(), forest->getUnits(*handler->getTree()).size());
    EXPECT_TRUE(shows("5.0 m high")) << overlayText();
    EXPECT_TRUE(shows(" Hz, leans "));
    click(x, y, 40.0f);
    EXPECT_TRUE(handler->getTree()) << "the camera was turned";
    click(10.0f, 470.0f);
    EXPECT_FALSE(handler->getTree()) << "the sky";
    click(x, y);
    ASSERT_TRUE(forest->removeTree(*handler->getTree()).empty());
    EXPECT_FALSE(shows("\ntree    "));
}

TEST_F(ForestHandlerTest, AHelicopterIsAddedAndRemoved) {
    const WindFieldPtr before = forest->getWind().field;
    press('r');
    EXPECT_TRUE(forest->getWind().sources.empty()) << "no tree is selected";
    click(320.0f, 230.0f);
    press('r');
    EXPECT_EQ(forest->getWind().field, before);
    EXPECT_LT(asField(forest->getWind())->velocity({0.0f, 0.0f, 8.0f}, 0.0).z, -2.0f)
        << "the wind carries part of the downwash off";
    EXPECT_TRUE(shows("10.0 m/s from 270\xc2\xb0, gusts 0 % and 1 sources")) << overlayText();
    press(Event::KEY_Up);
    const Wind stronger = forest->getWind();
    EXPECT_EQ(stronger.sources.size(), 1u) << "the source stays";
    EXPECT_NEAR(stronger.field->velocity({}, 0.0).x, 11.0f, 1e-5f);
    press(Event::KEY_Delete);
    EXPECT_TRUE(forest->getWind().sources.empty());
    EXPECT_NEAR(asField(forest->getWind())->velocity({}, 0.0).x, 11.0f, 1e-5f);
}

TEST_F(ForestHandlerTest, SourcesReplaceEachOtherUnlessKept) {
    const auto kinds = [this] {
        std::vector<WindSource::Kind> kinds;
        for (const WindSource& source : forest->getWind().sources)
            kinds.push_back(source.kind);
        return kinds;
    };
    using Kind = WindSource::Kind;
    click(320.0f, 230.0f);
    for (const std::vector<Kind>& expected : {std::vector<Kind>{Kind::Rotor},
                                              {Kind::Jet},
                                              {Kind::Vortex},
                                              {Kind::Shelter},
                                              {Kind::Explosion},
                                              {},
                                              {Kind::Rotor},
                                              {Kind::Jet}}) {
        press('r');
        EXPECT_EQ(kinds(), expected);
    }
    EXPECT_GT(asField(forest->getWind())->velocity({0.0f, 0.0f, 3.0f}, 0.0).x, 15.0f) << "at the tree";
    press('R');
    press('r');
    EXPECT_EQ(kinds(), (std::vector<Kind>{Kind::Jet, Kind::Rotor}));
    press(Event::KEY_Delete);
    press(Event::KEY_Delete);
    press(Event::KEY_Delete);
    EXPECT_TRUE(kinds().empty());
    press('r');
    EXPECT_EQ(kinds(), std::vector<Kind>{Kind::Rotor});
}

TEST_F(ForestHandlerTest, TogglesTheColoursOfTiers) {
    press('V');
    EXPECT_TRUE(forest->getStateSet()->getDefinePair("TIERS_COLORED"));
    EXPECT_TRUE(shows("red: full detail")) << overlayText();
    press('V');
    EXPECT_FALSE(forest->getStateSet()->getDefinePair("TIERS_COLORED"));
    EXPECT_FALSE(shows("red: full detail")) << overlayText();
}

TEST_F(ForestHandlerTest, TogglesTheArrows) {
    const unsigned before = forest->getNumChildren();
    press('a');
    overlayText();
    EXPECT_EQ(forest->getNumChildren(), before + 1);
    EXPECT_TRUE(forest->getChild(before)->getBound().valid());
    press('a');
    overlayText();
    EXPECT_EQ(forest->getNumChildren(), before);
}

TEST_F(ForestHandlerTest, ArrowsStandOverASmallForestBelowATransform) {
    osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(osg::Matrix::translate(5000, 300, 0));
    place->addChild(forest);
    view->setSceneData(place);
    const osg::Vec3 middle = forest->getBound().center();
    press('a');
    overlayText();
    const osg::Vec3 shown = forest->getChild(forest->getNumChildren() - 1)->getBound().center();
    EXPECT_LT((osg::Vec2(shown.x(), shown.y()) - osg::Vec2(middle.x(), middle.y())).length(), 5.0f);
}

TEST_F(ForestHandlerTest, StreaksTravelWithTheWind) {
    const unsigned before = forest->getNumChildren();
    press('A');
    runFrame(5.0);
    ASSERT_EQ(forest->getNumChildren(), before + 1);
    const osg::Geometry* streaks = forest->getChild(before)->asDrawable()->asGeometry();
    const osg::Array& places = *streaks->getVertexArray();
    const auto newest = [&](unsigned streak) { // seven lines of two points
        return static_cast<const osg::Vec3Array&>(places)[14 * streak];
    };
    std::vector<osg::Vec3> previous;
    for (unsigned i = 0; i < 100; ++i)
        previous.push_back(newest(i));
    runFrame(5.1);
    unsigned moved = 0; // the other streaks were restarted
    for (unsigned i = 0; i < 100; ++i)
        moved += (newest(i) - previous[i] - osg::Vec3(1.0f, 0.0f, 0.0f)).length() < 1e-3f;
    EXPECT_GT(moved, 70u) << "10 m/s from the west";
    press('A');
    overlayText();
    EXPECT_EQ(forest->getNumChildren(), before);
}

TEST_F(ForestHandlerTest, EveryKeyIsInTheHelpAndInTheUsage) {
    EXPECT_FALSE(shows("PageDown"));
    EXPECT_TRUE(press('h'));
    const std::string help = overlayText();
    const osg::ref_ptr<osg::ApplicationUsage> usage = new osg::ApplicationUsage;
    handler->getUsage(*usage);
    const auto& bindings = usage->getKeyboardMouseBindings();
    EXPECT_GE(bindings.size(), 20u);
    for (const auto& [key, does] : bindings)
        EXPECT_NE(help.find(does), std::string::npos) << key;
    press('i');
    press('h');
    EXPECT_EQ(overlayText(), "");
}

TEST_F(ForestHandlerTest, IgnoresOtherKeys) {
    EXPECT_FALSE(press('s'));
    EXPECT_FALSE(press(Event::KEY_Escape));
}

TEST_F(ForestHandlerTest, SurvivesTheForest) {
    view->setSceneData(nullptr);
    forest = nullptr;
    EXPECT_FALSE(press(Event::KEY_Up));
    EXPECT_EQ(handler->simulationTime(1.0), 0.0);
    EXPECT_FALSE(handler->getTree());
}

TEST_F(ForestHandlerTest, AcceptsAnEmptyForest) {
    EXPECT_TRUE(forest->setDescription({}).empty());
    for (const int key : {int(Event::KEY_Up), int('m'), int('a'), int('d'), int('h')})
        press(key);
    EXPECT_TRUE(shows("trees   0"));
}

} // namespace
