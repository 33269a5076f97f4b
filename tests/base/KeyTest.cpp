// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Key.h>

#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace osgTreeWind {

namespace {

enum class Colour { Red, Green };

struct Part {
    float share = 0.25f;
};

struct Whole {
    int count = 3;
    float angle = 0.5f; ///< Radians.
    double length = 2.0;
    Colour colour = Colour::Green;
    Part part;
};

} // namespace

template <>
const Keys& keysOf<Part>() {
    static const Keys keys = {{"share", at<&Part::share>, within(0, 0.3), ""}};
    return keys;
}

template <>
const Keys& keysOf<Whole>() {
    static const Keys keys = {{"count", at<&Whole::count>, within(1, 5), ""},
                              {"angle", at<&Whole::angle>, within(0, 180), "", "degrees"},
                              {"length", at<&Whole::length>, above(0), "", "m"},
                              {"colour", at<&Whole::colour>, {}, "", "", numberedFromZero({"red", "green"})},
                              {"part", at<&Whole::part>, {}, ""},
                              {"partShare", at<&Whole::part, &Part::share>, within(0, 1), ""}};
    return keys;
}

TEST(Key, ClampsNumbersOfNestedStructsAndReplacesNaN) {
    Whole whole;
    whole.count = 9;
    whole.angle = 4.0f;
    whole.part.share = std::numeric_limits<float>::quiet_NaN();
    const Whole clamped = clampedKeys(whole);
    EXPECT_EQ(clamped.count, 5);
    EXPECT_EQ(clamped.angle, glm::radians(180.0f));
    EXPECT_EQ(clamped.part.share, 0.25f);
    whole.count = -9;
    whole.part.share = 1.0f;
    EXPECT_EQ(clampedKeys(whole).count, 1);
    EXPECT_EQ(clampedKeys(whole).part.share, 0.3f) << "the limit rounded to float";
}

TEST(Key, ReportsNumbersInTheUnitOfTheField) {
    const auto problemsOf = [](const Whole& whole) {
        Diagnostics problems;
        checkKeys(whole, "trees[2]", problems);
        std::string text;
        for (const Diagnostic& problem : problems)
            text += problem.text() + '\n';
        return text;
    };
    Whole whole;
    whole.part.share = 0.3f; // above 0.3 as a double
    EXPECT_EQ(problemsOf(whole), "");
    whole.count = 0;
    whole.angle = -glm::radians(90.0f);
    whole.length = 0.0;
    whole.colour = static_cast<Colour>(7);
    whole.part.share = std::numeric_limits<float>::infinity();
    EXPECT_EQ(problemsOf(whole),
              "trees[2].count: expected a whole number in [1, 5], found 0\n"
              "trees[2].angle: expected a finite number in [0, 180] degrees, found -90 degrees\n"
              "trees[2].length: expected a finite number above 0, found 0\n"
              "trees[2].colour: expected a value of the enumeration, found 7\n"
              "trees[2].part.share: expected a finite number in [0, 0.3], found inf\n"
              "trees[2].partShare: expected a finite number in [0, 1], found inf\n");
}

TEST(Key, EqualityDistinguishesSignedZeros) {
    const Whole defaults;
    for (const Key& key : keysOf<Whole>())
        EXPECT_TRUE(isKeyEqual(key, &defaults, &defaults)) << key.name;
    Whole other;
    other.part.share = -0.0f;
    other.length = 0.0;
    other.colour = Colour::Red;
    Whole third = other;
    third.part.share = 0.0f;
    EXPECT_FALSE(isKeyEqual(keyAt(keysOf<Whole>(), "part"), &other, &third));
    EXPECT_TRUE(isKeyEqual(keyAt(keysOf<Whole>(), "length"), &other, &third));
    EXPECT_FALSE(isKeyEqual(keyAt(keysOf<Whole>(), "colour"), &other, &defaults));
}

TEST(Key, BytesDifferIfAnyFieldDiffers) {
    const auto bytes = [](const Whole& whole) {
        std::string text;
        addKeyBytes(whole, text);
        return text;
    };
    EXPECT_EQ(bytes({}), bytes({}));
    Whole whole;
    whole.part.share = std::nextafter(whole.part.share, 1.0f);
    EXPECT_NE(bytes(whole), bytes({}));
    whole = {};
    whole.colour = Colour::Red;
    EXPECT_NE(bytes(whole), bytes({}));
    whole = {};
    whole.length = -0.0;
    EXPECT_NE(bytes(whole), bytes({}));
}

} // namespace osgTreeWind
