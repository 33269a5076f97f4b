// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalStepJob.h>

#include <tests/motion/GrownTree.h>

#include <osgTreeWind/motion/modal/ModalTree.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace osgTreeWind {
namespace {

/// A step of one tree at rest.
class ModalStepJobTest : public testing::Test {
protected:
    ModalStepJobTest() : _archetype(oak.form()) {
        for (std::size_t level = 0; level < Archetype::levels; ++level)
            _state.groups.emplace_back(_archetype, level);
        _state.resize(1);
        _state.addToGroup(0, 0);
        _state.setFactors(0, _archetype.factors(oak.form(), 0.0f));
        job.state = &_state;
        job.wind = &_wind;
        job.seconds = 0.05f;
    }

    const GrownTree oak{"oak", {15, 0.3f, 0}};
    ModalStepJob job;

    glm::vec2 lean() const { return _state.leans[0]; }

private:
    Archetype _archetype;
    ModalState _state;
    UniformWind _wind{{8.0f, 0.0f, 0.0f}};
};

TEST_F(ModalStepJobTest, MovesATreeDownwind) {
    EXPECT_TRUE(job.run());
    EXPECT_GT(lean().x, 0.0f);
}

TEST_F(ModalStepJobTest, ZeroSecondsSetTheWindAndMoveNothing) {
    job.seconds = 0.0f;
    EXPECT_TRUE(job.run());
    EXPECT_EQ(lean(), glm::vec2(0.0f));
}

TEST_F(ModalStepJobTest, AnInvalidJobChangesNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    ModalStepJob noState = job, back = job, noNumber = job, never = job, noTurns = job;
    noState.state = nullptr;
    back.seconds = -0.05f;
    noNumber.seconds = nan;
    never.time = HUGE_VAL;
    noTurns.turns = 0;
    for (const ModalStepJob& broken : {noState, back, noNumber, never, noTurns}) {
        EXPECT_FALSE(broken.validate());
        EXPECT_FALSE(broken.run());
    }
    EXPECT_EQ(lean(), glm::vec2(0.0f));
}

} // namespace
} // namespace osgTreeWind
