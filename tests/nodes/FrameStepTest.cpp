// SPDX-License-Identifier: MIT
// The fixed frame step of a file or of the environment, for hosts without regular frame times.
#include <tests/EnvironmentVariable.h>
#include <tests/MessageCollector.h>
#include <tests/nodes/ForestFixtures.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

/// States after `frames` frames at the times that `hostTime` returns.
std::vector<glm::vec4> statesAfter(const osg::ref_ptr<Forest>& forest, unsigned frames,
                                   double (*hostTime)(unsigned)) {
    for (unsigned frame = 1; frame <= frames; ++frame)
        update(*forest, frame, hostTime(frame));
    return statesOf(*forest);
}

double regularTime(unsigned frame) {
    return frame / 25.0;
}
double wallClock(unsigned frame) {
    return 0.1 * frame + 0.013 * ((frame * 7919) % 11);
}
double noTime(unsigned) {
    return 0.0;
}

ForestDescription withStep(double step) {
    ForestDescription description = smallForest(3);
    description.step = step;
    return description;
}

} // namespace

TEST(FrameStep, OfTheFileOverridesTheHostsTime) {
    const std::vector<glm::vec4> expected = statesAfter(new Forest(smallForest(3)), 60, regularTime);
    EXPECT_EQ(statesAfter(new Forest(withStep(0.04)), 60, wallClock), expected);
    EXPECT_EQ(statesAfter(new Forest(withStep(0.04)), 60, noTime), expected);
    EXPECT_NE(statesAfter(new Forest(smallForest(3)), 60, wallClock), expected);
    EXPECT_NE(statesAfter(new Forest(withStep(0.02)), 60, wallClock), expected);
}

TEST(FrameStep, OfTheEnvironmentOverridesTheFile) {
    const std::vector<glm::vec4> expected = statesAfter(new Forest(smallForest(3)), 60, regularTime);
    {
        const EnvironmentVariable step("OSGTREEWIND_STEP", "0.04");
        EXPECT_EQ(statesAfter(new Forest(smallForest(3)), 60, noTime), expected);
        EXPECT_EQ(statesAfter(new Forest(withStep(0.5)), 60, wallClock), expected);
    }
    const EnvironmentVariable step("OSGTREEWIND_STEP", "0");
    EXPECT_EQ(statesAfter(new Forest(withStep(0.5)), 60, regularTime), expected) << "the host's time";
}

TEST(FrameStep, IsCopied) {
    const osg::ref_ptr<Forest> forest = new Forest(withStep(0.04));
    const osg::ref_ptr<Forest> copy = osg::clone(forest.get());
    EXPECT_EQ(statesAfter(copy, 60, wallClock), statesAfter(forest, 60, noTime));
}

TEST(FrameStep, AnInvalidVariableIsIgnoredWithOneWarning) {
    const ScopedMessages messages;
    const std::vector<glm::vec4> expected = statesAfter(new Forest(withStep(0.04)), 60, noTime);
    for (const char* nonsense : {"fast", "-1", "nan", "0.04s", "1e9"}) {
        const EnvironmentVariable step("OSGTREEWIND_STEP", nonsense);
        EXPECT_EQ(statesAfter(new Forest(withStep(0.04)), 60, noTime), expected) << nonsense;
    }
    EXPECT_EQ(
        messages.take(),
        "osgTreeWind: OSGTREEWIND_STEP: expected seconds, a finite number in [0, 60], found 'fast'; the "
        "variable is ignored\n");
}
