// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

TEST(MessageText, ExpectedFoundQuotesTheText) {
    EXPECT_EQ(expectedFound("a number", " abc "), "expected a number, found 'abc'");
    EXPECT_EQ(expectedFound("a number", "1\n2"), "expected a number, found '1 2'");
    EXPECT_EQ(expectedFound("a number", " "), "expected a number, found nothing");
    EXPECT_EQ(expectedFound("a number", std::string(50, 'x')),
              "expected a number, found '" + std::string(40, 'x') + "...'");
}

} // namespace osgTreeWind
