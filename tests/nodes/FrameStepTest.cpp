// SPDX-License-Identifier: MIT
// Hosts that give no time, or that of the wall: a frame lasts as long as the file or the environment says.
#include <tests/EnvironmentVariable.h>
#include <tests/MessageCollector.h>
#include <tests/nodes/ForestFixtures.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

/// States after so many frames of a host whose time is anything.
std::vector<glm::vec4> statesAfter(const osg::ref_ptr<Forest>& forest, unsigned frames,
                                   double (*hostTime)(unsigned)) {
    for (unsigned frame = 1; frame <= frames; ++frame)
        update(*forest, frame, hostTime(frame));
    return statesOf(*forest);
}

double regular(unsigned frame) {
    return frame / 25.0;
}
double wall(unsigned frame) {
    return 0.1 * frame + 0.013 * ((frame * 7919) % 11);
}
double none(unsigned) {
    return 0.0;
}

ForestDescription stepping(double step) {
    ForestDescription description = smallForest(3);
    description.step = step;
    return description;
}

} // namespace

TEST(FrameStep, ofTheFileHoldsWhateverTheHostsTime) {
    const std::vector<glm::vec4> expected = statesAfter(new Forest(smallForest(3)), 60, regular);
    EXPECT_EQ(statesAfter(new Forest(stepping(0.04)), 60, wall), expected);
    EXPECT_EQ(statesAfter(new Forest(stepping(0.04)), 60, none), expected);
    EXPECT_NE(statesAfter(new Forest(smallForest(3)), 60, wall), expected);
    EXPECT_NE(statesAfter(new Forest(stepping(0.02)), 60, wall), expected);
}

TEST(FrameStep, ofTheEnvironmentWinsOverThatOfTheFile) {
    const std::vector<glm::vec4> expected = statesAfter(new Forest(smallForest(3)), 60, regular);
    {
        const EnvironmentVariable step("OSGTREEWIND_STEP", "0.04");
        EXPECT_EQ(statesAfter(new Forest(smallForest(3)), 60, none), expected);
        EXPECT_EQ(statesAfter(new Forest(stepping(0.5)), 60, wall), expected);
    }
    const EnvironmentVariable step("OSGTREEWIND_STEP", "0");
    EXPECT_EQ(statesAfter(new Forest(stepping(0.5)), 60, regular), expected) << "the host's time";
}

TEST(FrameStep, ofACopyIsTheSame) {
    const osg::ref_ptr<Forest> forest = new Forest(stepping(0.04));
    const osg::ref_ptr<Forest> copy = osg::clone(forest.get());
    EXPECT_EQ(statesAfter(copy, 60, wall), statesAfter(forest, 60, none));
}

TEST(FrameStep, nonsenseInTheEnvironmentIsSaidOnceAndNotUsed) {
    osg::ref_ptr<MessageCollector> messages = new MessageCollector;
    osg::setNotifyHandler(messages);
    const std::vector<glm::vec4> expected = statesAfter(new Forest(stepping(0.04)), 60, none);
    for (const char* nonsense : {"fast", "-1", "nan", "0.04s", "1e9"}) {
        const EnvironmentVariable step("OSGTREEWIND_STEP", nonsense);
        EXPECT_EQ(statesAfter(new Forest(stepping(0.04)), 60, none), expected) << nonsense;
    }
    osg::setNotifyHandler(new osg::StandardNotifyHandler);
    EXPECT_EQ(
        messages->take(),
        "osgTreeWind: OSGTREEWIND_STEP: expected seconds, a finite number in [0, 60], found 'fast'; it is "
        "not used\n");
}
