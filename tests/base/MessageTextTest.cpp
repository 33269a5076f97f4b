// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Result.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

TEST(MessageText, ExpectedFoundQuotesTheText) {
    EXPECT_EQ(expectedFound("a number", " abc "), "expected a number, found 'abc'");
    EXPECT_EQ(expectedFound("a number", "1\n2"), "expected a number, found '1 2'");
    EXPECT_EQ(expectedFound("a number", " "), "expected a number, found nothing");
    EXPECT_EQ(expectedFound("a number", std::string(50, 'x')),
              "expected a number, found '" + std::string(40, 'x') + "...'");
}

TEST(MessageText, IsUtf8) {
    const std::string umlauts = "\xc3\xa4\xc3\xb6\xc3\xbc"; // 6 bytes
    EXPECT_EQ(expectedFound("a", std::string(37, 'x') + umlauts),
              "expected a, found '" + std::string(37, 'x') + "\xc3\xa4...'")
        << "characters are not split";
    EXPECT_EQ(expectedFound("a", "\xe4"), "expected a, found '\xc3\xa4'") << "Windows-1252";
    EXPECT_EQ(joined({"a\x80\n", "\xc3\xa4"}), "a\xe2\x82\xac?, \xc3\xa4");
    EXPECT_EQ((Diagnostic{"B\xe4ume.csv", 2, 0, "H\xf6he", "expected a number"}.text()),
              "B\xc3\xa4ume.csv:2: H\xc3\xb6he: expected a number");
}

} // namespace osgTreeWind
