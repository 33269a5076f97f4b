// SPDX-License-Identifier: MIT
// Keeps one osgtreewind-map alive for all tests of a program, because starting it takes 0.2 s.
#include <osgTreeWind/places/MapProgram.h>

#include <gtest/gtest.h>

namespace {

class SharedMapProgram : public testing::Environment {
    void SetUp() override { _held = osgTreeWind::MapProgram::shared(); }
    void TearDown() override { _held.reset(); }

    std::shared_ptr<osgTreeWind::MapProgram> _held;
};

testing::Environment* const held = testing::AddGlobalTestEnvironment(new SharedMapProgram);

} // namespace
