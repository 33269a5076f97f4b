// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/PortableMath.h>

#include <osgTreeWind/base/Random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace osgTreeWind {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double quietNaN = std::numeric_limits<double>::quiet_NaN();

using OfOne = double (*)(double);
using OfTwo = double (*)(double, double);

/// Arguments: uniform in a range, or of any size and sign.
class Arguments {
public:
    double within(double low, double high) { return low + (high - low) * _random.uniformDouble(); }
    double anySize(double lowExponent, double highExponent) {
        const double size = std::ldexp(1.0 + _random.uniformDouble(),
                                       static_cast<int>(std::floor(within(lowExponent, highExponent))));
        return _random.uniform() < 0.5f ? -size : size;
    }

private:
    Random _random{1};
};

/// Hashes the bits of values.
class BitHash {
public:
    void add(double value) {
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        _hash = (_hash ^ bits) * 0x100000001b3ull;
        _hash ^= _hash >> 32;
    }
    std::uint64_t value() const { return _hash; }

private:
    std::uint64_t _hash = 0xcbf29ce484222325ull;
};

std::uint64_t hashOf(OfOne function, double low, double high) {
    Arguments arguments;
    BitHash hash;
    for (int i = 0; i < 20000; ++i)
        hash.add(function(i % 2 ? arguments.within(low, high) : low + (high - low) * i / 20000.0));
    return hash.value();
}
std::uint64_t hashOf(OfTwo function, double low, double high) {
    Arguments arguments;
    BitHash hash;
    for (int i = 0; i < 20000; ++i) {
        const double first = arguments.within(low, high);
        hash.add(function(first, arguments.within(-8.0, 8.0)));
    }
    return hash.value();
}

TEST(PortableMath, HasTheBitsOfEverySystem) {
    EXPECT_EQ(hashOf(math::sin, -1e6, 1e6), 0x865bfc53646e4ff3ull);
    EXPECT_EQ(hashOf(math::sin, -4.0, 4.0), 0x60f36f4e5361241bull);
    EXPECT_EQ(hashOf(math::cos, -4.0, 4.0), 0x82b53041e24ecd4dull);
    EXPECT_EQ(hashOf(math::tan, -4.0, 4.0), 0xabfe16cfff5eecd0ull);
    EXPECT_EQ(hashOf(math::asin, -1.0, 1.0), 0x56de8ff7877244a5ull);
    EXPECT_EQ(hashOf(math::acos, -1.0, 1.0), 0x6efae1a62fb7830cull);
    EXPECT_EQ(hashOf(math::atan, -20.0, 20.0), 0x8731693f5d53c3cdull);
    EXPECT_EQ(hashOf(math::atan2, -8.0, 8.0), 0xd25dd9fa1fc133c6ull);
    EXPECT_EQ(hashOf(math::exp, -750.0, 710.0), 0x263e75f108b59a2cull);
    EXPECT_EQ(hashOf(math::log, 0.0, 50.0), 0x43ff7f2f27468a25ull);
    EXPECT_EQ(hashOf(math::log2, 0.0, 50.0), 0xa35dca8d21c5b0bfull);
    EXPECT_EQ(hashOf(math::log10, 0.0, 50.0), 0x8a878fc7cd410009ull);
    EXPECT_EQ(hashOf(math::pow, 0.0, 50.0), 0x213876981f206796ull);
    EXPECT_EQ(hashOf(math::cbrt, -50.0, 50.0), 0xd56a2f88f4261b35ull);
    EXPECT_EQ(hashOf(math::hypot, -8.0, 8.0), 0x304223b18d0c5c72ull);
    EXPECT_EQ(hashOf(math::erf, -7.0, 7.0), 0x0118d6c7df851955ull);
}

#ifdef __GLIBC__ // whose functions of long double are the reference; that other systems agree, the hashes
                 // show

using Reference = long double (*)(long double);

/// The error of `result` in units of the last place.
double error(double result, long double exact) {
    if (exact == 0.0L)
        return result == 0.0 ? 0.0 : infinite;
    const int exponent = std::max(std::ilogb(exact), std::numeric_limits<double>::min_exponent - 1);
    return static_cast<double>(std::fabs(result - exact) / std::ldexp(1.0L, exponent - 52));
}

/// The largest error of results of arguments that `next()` gives.
template <typename Next>
double largestError(OfOne function, Reference exact, const Next& next) {
    double largest = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const double x = next();
        largest = std::max(largest, error(function(x), exact(x)));
    }
    return largest;
}
double errorWithin(OfOne function, Reference exact, double low, double high) {
    Arguments arguments;
    return largestError(function, exact, [&] { return arguments.within(low, high); });
}
/// Of arguments between 2^low and 2^high.
double errorOfSizes(OfOne function, Reference exact, double low, double high) {
    Arguments arguments;
    return largestError(function, exact, [&] { return arguments.anySize(low, high); });
}

TEST(PortableMathErrors, OfAnglesAreBelow1) {
    for (const double range : {1.0, 10.0, 1e9}) {
        EXPECT_LT(errorWithin(math::sin, std::sin, -range, range), 1.0) << range;
        EXPECT_LT(errorWithin(math::cos, std::cos, -range, range), 1.0) << range;
        EXPECT_LT(errorWithin(math::tan, std::tan, -range, range), 1.0) << range;
    }
    EXPECT_LT(errorOfSizes(math::sin, std::sin, -1074.0, 30.0), 1.0);
    EXPECT_LT(errorOfSizes(math::tan, std::tan, -1074.0, 30.0), 1.0);
}

TEST(PortableMathErrors, NearMultiplesOfARightAngleAreBelow1) {
    Arguments arguments;
    const auto nearRightAngles = [&] {
        return static_cast<double>(std::floor(static_cast<long double>(arguments.within(0.0, 6e8))) *
                                   1.57079632679489661923L);
    };
    EXPECT_LT(largestError(math::sin, std::sin, nearRightAngles), 1.0);
    EXPECT_LT(largestError(math::cos, std::cos, nearRightAngles), 1.0);
    EXPECT_LT(largestError(math::tan, std::tan, nearRightAngles), 1.0);
}

TEST(PortableMathErrors, OfArcsAreBelow052) {
    EXPECT_LT(errorWithin(math::asin, std::asin, -1.0, 1.0), 0.52);
    EXPECT_LT(errorOfSizes(math::asin, std::asin, -1074.0, -1.0), 0.52);
    EXPECT_LT(errorWithin(math::acos, std::acos, -1.0, 1.0), 0.52);
    EXPECT_LT(errorWithin(math::acos, std::acos, 1.0 - 1e-9, 1.0), 0.52);
    EXPECT_LT(errorWithin(math::atan, std::atan, -3.0, 3.0), 0.52);
    EXPECT_LT(errorOfSizes(math::atan, std::atan, -1074.0, 1023.0), 0.52);
}

TEST(PortableMathErrors, OfPowersAndLogarithmsAreBelow052) {
    EXPECT_LT(errorWithin(math::exp, std::exp, -708.0, 709.0), 0.52);
    EXPECT_LT(errorOfSizes(math::exp, std::exp, -1074.0, 9.0), 0.52);
    EXPECT_LT(errorWithin(math::exp, std::exp, -746.0, -708.0), 1.0); // below the smallest normal number
    for (const double low : {0.0, 0.999}) {
        EXPECT_LT(errorWithin(math::log, std::log, low, 2.0 - low), 0.52);
        EXPECT_LT(errorWithin(math::log2, std::log2, low, 2.0 - low), 0.52);
        EXPECT_LT(errorWithin(math::log10, std::log10, low, 2.0 - low), 0.52);
    }
    EXPECT_LT(errorOfSizes([](double x) { return math::log(std::fabs(x)); },
                           [](long double x) { return std::log(std::fabs(x)); }, -1074.0, 1023.0),
              0.52);
    EXPECT_LT(errorOfSizes(math::cbrt, std::cbrt, -1074.0, 1023.0), 0.52);
}

TEST(PortableMathErrors, OfErfAreBelow2) {
    EXPECT_LT(errorWithin(math::erf, std::erf, -7.0, 7.0), 2.0);
    EXPECT_LT(errorOfSizes(math::erf, std::erf, -1020.0, 0.0), 2.0);
}

TEST(PortableMathErrors, OfTwoArgumentsAreBelow052) {
    Arguments arguments;
    double ofPow = 0.0, ofHypot = 0.0, ofAtan2 = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const double base = std::fabs(arguments.anySize(-1000.0, 1000.0)),
                     exponent = arguments.within(-700.0, 700.0) / std::log(base);
        ofPow = std::max(
            ofPow, error(math::pow(base, exponent), std::pow(static_cast<long double>(base), exponent)));
        const double x = arguments.anySize(-1000.0, 1000.0), y = x * arguments.anySize(-20.0, 20.0);
        ofHypot = std::max(ofHypot, error(math::hypot(x, y), std::hypot(static_cast<long double>(x), y)));
        ofAtan2 = std::max(ofAtan2, error(math::atan2(y, x), std::atan2(static_cast<long double>(y), x)));
    }
    EXPECT_LT(ofPow, 0.52);
    EXPECT_LT(ofHypot, 0.52);
    EXPECT_LT(ofAtan2, 0.52);
}

#endif

TEST(PortableMath, IsExactWhereTheResultIs) {
    for (int i = -300; i <= 300; ++i) {
        EXPECT_EQ(math::log2(std::ldexp(1.0, i)), i);
        EXPECT_EQ(math::pow(2.0, i), std::ldexp(1.0, i));
    }
    double tens = 1.0;
    for (int i = 0; i <= 22; ++i, tens *= 10.0) {
        EXPECT_EQ(math::log10(tens), i);
        EXPECT_EQ(math::pow(10.0, i), tens);
    }
    for (int i = 1; i < 1000; ++i)
        EXPECT_EQ(math::cbrt(-static_cast<double>(i) * i * i), -i);
    EXPECT_EQ(math::hypot(-0x3p600, 0x4p600), 0x5p600);
    EXPECT_EQ(math::exp(0.0), 1.0);
    EXPECT_EQ(math::cos(0.0), 1.0);
    EXPECT_EQ(math::acos(1.0), 0.0);
}

TEST(PortableMath, KeepsTheSignOfZero) {
    for (const OfOne odd : {OfOne(math::sin), OfOne(math::tan), OfOne(math::asin), OfOne(math::atan),
                            OfOne(math::cbrt), OfOne(math::erf)}) {
        EXPECT_EQ(odd(-0.0), 0.0);
        EXPECT_TRUE(std::signbit(odd(-0.0)));
        EXPECT_FALSE(std::signbit(odd(0.0)));
    }
}

/// Equal, with the sign of zero, or both NaN.
void expectSame(double result, double expected) {
    EXPECT_TRUE(std::isnan(expected) ? std::isnan(result)
                                     : result == expected && std::signbit(result) == std::signbit(expected))
        << result << ", expected " << expected;
}

// The C library is right here: Annex F of C leaves it no choice.
TEST(PortableMath, SpecialValuesAreThoseOfC) {
    const double values[] = {0.0,  -0.0,  0.5,    -0.5,   1.0,     -1.0,     2.0,       -2.0,    3.0,
                             -3.0, 1e300, -1e300, 5e-324, -5e-324, infinite, -infinite, quietNaN};
    for (const double x : values) {
        SCOPED_TRACE(x);
        for (const double y : values) {
            SCOPED_TRACE(y);
            const double power = std::pow(x, y), angle = std::atan2(x, y);
            expectSame(math::pow(x, y), power);
            expectSame(static_cast<float>(math::atan2(x, y)), static_cast<float>(angle));
            expectSame(math::hypot(x, y), std::hypot(x, y));
        }
    }
    for (const OfOne function :
         {OfOne(math::sin), OfOne(math::cos), OfOne(math::tan), OfOne(math::asin), OfOne(math::acos)}) {
        EXPECT_TRUE(std::isnan(function(infinite)));
        EXPECT_TRUE(std::isnan(function(-infinite)));
        EXPECT_TRUE(std::isnan(function(quietNaN)));
    }
    for (const OfOne logarithm : {OfOne(math::log), OfOne(math::log2), OfOne(math::log10)}) {
        expectSame(logarithm(0.0), -infinite);
        expectSame(logarithm(-0.0), -infinite);
        expectSame(logarithm(-1.0), quietNaN);
        expectSame(logarithm(infinite), infinite);
        expectSame(logarithm(quietNaN), quietNaN);
    }
    expectSame(math::exp(infinite), infinite);
    expectSame(math::exp(710.0), infinite);
    expectSame(math::exp(-infinite), 0.0);
    expectSame(math::exp(-746.0), 0.0);
    expectSame(math::exp(quietNaN), quietNaN);
    expectSame(math::cbrt(-infinite), -infinite);
    expectSame(math::cbrt(quietNaN), quietNaN);
    expectSame(math::erf(-infinite), -1.0);
    expectSame(math::erf(quietNaN), quietNaN);
    EXPECT_TRUE(std::isnan(math::asin(1.0 + 1e-15)));
}

TEST(PortableMath, FloatsAreRoundedDoubles) {
    Random random(3);
    for (int i = 0; i < 100000; ++i) {
        const float size = i % 2 ? 1.0f : 1000.0f, x = size * random.symmetric(), y = random.symmetric();
        const double wide = x;
        EXPECT_EQ(math::sin(x), static_cast<float>(math::sin(wide)));
        EXPECT_EQ(math::cos(x), static_cast<float>(math::cos(wide)));
        EXPECT_EQ(math::exp(x), static_cast<float>(math::exp(wide)));
        EXPECT_EQ(math::log(std::abs(x)), static_cast<float>(math::log(std::abs(wide))));
        EXPECT_EQ(math::pow(std::abs(x), y), static_cast<float>(math::pow(std::abs(wide), double(y))));
    }
    EXPECT_EQ(math::sin(1e9f), static_cast<float>(math::sin(1e9)));
    EXPECT_TRUE(std::signbit(math::sin(-0.0f)));
    EXPECT_TRUE(std::isnan(math::cos(std::numeric_limits<float>::infinity())));
}

} // namespace
} // namespace osgTreeWind
