// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Field.h>

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
const Fields& fieldsOf<Part>() {
    static const Fields fields = {{"share", at<&Part::share>, within(0, 0.3), ""}};
    return fields;
}

template <>
const Fields& fieldsOf<Whole>() {
    static const Fields fields = {
        {"count", at<&Whole::count>, within(1, 5), ""},
        {"angle", at<&Whole::angle>, within(0, 180), "", "degrees"},
        {"length", at<&Whole::length>, above(0), "", "m"},
        {"colour", at<&Whole::colour>, {}, "", "", numberedFromZero({"red", "green"})},
        {"part", at<&Whole::part>, {}, ""},
        {"partShare", at<&Whole::part, &Part::share>, within(0, 1), ""}};
    return fields;
}

TEST(Field, ClampsNumbersOfNestedStructsAndReplacesNaN) {
    Whole whole;
    whole.count = 9;
    whole.angle = 4.0f;
    whole.part.share = std::numeric_limits<float>::quiet_NaN();
    const Whole clamped = clampedFields(whole);
    EXPECT_EQ(clamped.count, 5);
    EXPECT_EQ(clamped.angle, glm::radians(180.0f));
    EXPECT_EQ(clamped.part.share, 0.25f);
    whole.count = -9;
    whole.part.share = 1.0f;
    EXPECT_EQ(clampedFields(whole).count, 1);
    EXPECT_EQ(clampedFields(whole).part.share, 0.3f) << "the limit rounded to float";
}

TEST(Field, ReportsNumbersInTheUnitOfTheField) {
    const auto problemsOf = [](const Whole& whole) {
        Diagnostics problems;
        checkFields(whole, "trees[2]", problems);
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

TEST(Field, EqualityDistinguishesSignedZeros) {
    const Whole defaults;
    for (const Field& field : fieldsOf<Whole>())
        EXPECT_TRUE(isFieldEqual(field, &defaults, &defaults)) << field.key;
    Whole other;
    other.part.share = -0.0f;
    other.length = 0.0;
    other.colour = Colour::Red;
    Whole third = other;
    third.part.share = 0.0f;
    EXPECT_FALSE(isFieldEqual(fieldAt(fieldsOf<Whole>(), "part"), &other, &third));
    EXPECT_TRUE(isFieldEqual(fieldAt(fieldsOf<Whole>(), "length"), &other, &third));
    EXPECT_FALSE(isFieldEqual(fieldAt(fieldsOf<Whole>(), "colour"), &other, &defaults));
}

TEST(Field, BytesDifferIfAnyFieldDiffers) {
    const auto bytes = [](const Whole& whole) {
        std::string text;
        addFieldBytes(whole, text);
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
