// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/BadAccess.h>
#include <osgTreeWind/base/Result.h>

#include <gtest/gtest.h>

#include <memory>
#include <string>

using namespace osgTreeWind;

TEST(Diagnostic, TextContainsAllKnownParts) {
    EXPECT_EQ((Diagnostic{"a.treewind", 3, 7, "wind.speed", "expected m/s"}.text()),
              "a.treewind:3:7: wind.speed: expected m/s");
}

TEST(Diagnostic, TextOmitsUnknownParts) {
    EXPECT_EQ((Diagnostic{"a.csv", 3, 0, {}, "ragged"}.text()), "a.csv:3: ragged");
    EXPECT_EQ((Diagnostic{"a.csv", 0, 5, {}, "empty"}.text()), "a.csv: empty");
    EXPECT_EQ((Diagnostic{{}, 0, 0, "cell", "wrong"}.text()), "cell: wrong");
    EXPECT_EQ((Diagnostic{{}, 0, 0, {}, "wrong"}.text()), "wrong");
}

TEST(Diagnostic, ToStringWritesOneLinePerProblem) {
    EXPECT_EQ(toString({}), "");
    EXPECT_EQ(toString({{"f", 1, 0, {}, "first"}, {"f", 2, 0, {}, "second"}}), "f:1: first\nf:2: second");
}

TEST(Result, HoldsAValueOrItsProblems) {
    const Result<int> good = 3;
    ASSERT_TRUE(good.ok());
    EXPECT_EQ(good.value(), 3);

    const Result<int> bad = Diagnostics{{"f", 1, 0, {}, "first"}, {"f", 2, 0, {}, "second"}};
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.problems().size(), 2u);
    EXPECT_EQ(bad.problems().back().line, 2);
}

TEST(Result, ValueOfAnErrorIsDefaultConstructedWithAWarning) {
    stopAtBadAccess(false);
    testing::internal::CaptureStderr();
    EXPECT_EQ(Result<int>(Diagnostic{"f", 3, 0, {}, "third"}).value(), 0);
    EXPECT_EQ(Result<std::string>(Diagnostics{{"f", 4, 0, {}, "fourth"}}).value(), "");
    EXPECT_EQ(Result<std::shared_ptr<int>>(Diagnostic{"f", 5, 0, {}, "fifth"}).value(), nullptr);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "osgTreeWind: value() of a failed Result: f:3: third\n"
              "osgTreeWind: value() of a failed Result: f:4: fourth\n"
              "osgTreeWind: value() of a failed Result: f:5: fifth\n");
    stopAtBadAccess();
    EXPECT_TRUE(Result<int>(3).problems().empty());
}

TEST(Result, ValueOfAnErrorStopsTestsAndTool) {
    EXPECT_DEATH(Result<int>(Diagnostic{"f", 3, 0, {}, "third"}).value(), "failed Result: f:3: third");
}
