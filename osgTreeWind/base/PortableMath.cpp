// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/PortableMath.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace osgTreeWind::math {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(),
                 notANumber = std::numeric_limits<double>::quiet_NaN();

/// The unevaluated sum of a double and its rounding error, about 106 bits (Dekker 1971).
struct Precise {
    double high, low = 0.0;
};

constexpr Precise pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53}, halfPi{0.5 * pi.high, 0.5 * pi.low};
constexpr double perHalfPi = 0.6366197723675814;
constexpr Precise ln2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

/// a + b (Knuth).
constexpr Precise sum(double a, double b) {
    const double high = a + b, ofB = high - a;
    return {high, (a - (high - ofB)) + (b - ofB)};
}
/// a + b, if |a| >= |b| or a is 0.
constexpr Precise orderedSum(double a, double b) {
    const double high = a + b;
    return {high, b - (high - a)};
}
/// `x` in two parts of at most 26 bits, whose products are exact (Veltkamp).
constexpr Precise halves(double x) {
    const double wide = 0x8000001p0 * x, high = wide - (wide - x);
    return {high, x - high};
}
constexpr Precise product(double a, double b) {
    const Precise x = halves(a), y = halves(b);
    const double high = a * b;
    return {high, ((x.high * y.high - high) + x.high * y.low + x.low * y.high) + x.low * y.low};
}
constexpr Precise operator-(const Precise& a) {
    return {-a.high, -a.low};
}
constexpr Precise operator+(const Precise& a, const Precise& b) {
    const Precise high = sum(a.high, b.high);
    return orderedSum(high.high, high.low + (a.low + b.low));
}
constexpr Precise operator-(const Precise& a, const Precise& b) {
    return a + -b;
}
constexpr Precise operator*(const Precise& a, const Precise& b) {
    const Precise high = product(a.high, b.high);
    return orderedSum(high.high, high.low + (a.high * b.low + a.low * b.high));
}
constexpr Precise operator/(const Precise& a, const Precise& b) {
    const double high = a.high / b.high;
    const Precise back = product(high, b.high);
    return orderedSum(high, ((a.high - back.high) - back.low + a.low - high * b.low) / b.high);
}
Precise root(const Precise& x) {
    const double high = std::sqrt(x.high);
    const Precise back = product(high, high);
    return high > 0.0 ? orderedSum(high, ((x.high - back.high) - back.low + x.low) / (2.0 * high))
                      : Precise{high};
}

std::uint64_t bitsOf(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}
double fromBits(std::uint64_t bits) {
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}
/// The nearest whole number, for |x| < 2^51.
double nearest(double x) {
    constexpr double whole = 0x1.8p52; // has no bits after the point
    return (x + whole) - whole;
}

/// 2^(i / 64).
constexpr int stepsPerOctave = 64;
constexpr auto powersOfTwo = [] {
    std::array<Precise, stepsPerOctave> powers{};
    constexpr Precise step{0x1.02c9a3e778061p+0, -0x1.19083535b085dp-56};
    powers[0] = {1.0};
    for (std::size_t i = 1; i < powers.size(); ++i)
        powers[i] = powers[i - 1] * step;
    return powers;
}();

constexpr double stepHigh = 0x1.62e42feep-7, stepLow = 0x1.a39ef35793c76p-39; // ln 2 / 64

double exponential(const Precise& x) {
    if (!(std::fabs(x.high) < 1000.0))
        return x.high > 0.0 ? infinity : x.high < 0.0 ? 0.0 : x.high;
    const double steps = nearest(x.high * (stepsPerOctave / ln2.high));
    const double r = (x.high - steps * stepHigh) + (x.low - steps * stepLow), r2 = r * r;
    const double more =
        r + r2 * ((0.5 + r * (1.0 / 6.0)) + r2 * ((1.0 / 24.0 + r * (1.0 / 120.0)) + r2 * (1.0 / 720.0)));
    const int whole = static_cast<int>(steps), i = whole & (stepsPerOctave - 1),
              exponent = (whole - i) / stepsPerOctave;
    const Precise& power = powersOfTwo[static_cast<std::size_t>(i)];
    const double result = power.high + (power.low + power.high * more);
    if (exponent > -1022 && exponent < 1023)
        return result * fromBits(static_cast<std::uint64_t>(1023 + exponent) << 52);
    return std::ldexp(result, exponent);
}

/// c near i / 128, rounded so that the products of 1 / c and halves are exact, and ln c in a part that is a
/// multiple of 2^-42 and the rest.
struct TableLog {
    double inverse;
    Precise log;
};
constexpr double lowestLog = 181.0 / 256.0;
constexpr int firstLog = 90, lastLog = 181;
constexpr auto logs = [] {
    std::array<TableLog, lastLog - firstLog + 1> table{};
    for (int i = firstLog; i <= lastLog; ++i) {
        TableLog& entry = table[static_cast<std::size_t>(i - firstLog)];
        entry.inverse = static_cast<int>(1024.0 * 128.0 / i + 0.5) / 1024.0;
        const Precise s = Precise{1.0 - entry.inverse} / Precise{1.0 + entry.inverse}, s2 = s * s;
        Precise series{0.0}; // ln c = 2 artanh((c - 1) / (c + 1))
        for (int n = 45; n > 0; n -= 2)
            series = series * s2 + Precise{2.0} / Precise{static_cast<double>(n)};
        const Precise log = series * s;
        const double whole = log.high * 0x1p42,
                     high = static_cast<double>(static_cast<std::int64_t>(whole)) * 0x1p-42;
        entry.log = {high, (log.high - high) + log.low};
    }
    return table;
}();

/// x = 2^exponent z, z / c = 1 + r, with r in two parts. ln x = exponent ln 2 + ln c + ln(1 + r).
struct Divided {
    double exponent;
    const TableLog& entry;
    double high, low;

    /// The sum of the first two terms: a part whose sum is exact, and the rest.
    double highLog() const { return exponent * 0x1.62e42fefa38p-1 + entry.log.high; }
    double lowLog() const { return exponent * 0x1.ef35793c7673p-45 + entry.log.low; }
};
/// @param x finite, above 0.
Divided divided(double x) {
    int exponent = 0;
    if (x < std::numeric_limits<double>::min()) {
        x *= 0x1p54;
        exponent = -54;
    }
    const std::uint64_t bits = bitsOf(x), above = bits - bitsOf(lowestLog);
    exponent += static_cast<int>(static_cast<std::int64_t>(above) >> 52);
    const double z = fromBits(bits - (above & 0xfffull << 52)); // in [lowestLog, 2 lowestLog)
    const TableLog& entry = logs[static_cast<std::size_t>(static_cast<int>(128.0 * z + 0.5) - firstLog)];
    const double high = fromBits((bitsOf(z) + 0x4000000) & ~0x7ffffffull); // 26 bits, rounded
    return {static_cast<double>(exponent), entry, high * entry.inverse - 1.0, (z - high) * entry.inverse};
}

/// ln x of a finite x > 0, with an error below 2^-67 of the result.
Precise logarithm(double x) {
    const Divided parts = divided(x);
    const Precise r = orderedSum(parts.high, parts.low), half = halves(r.high);
    const double square = 0.5 * half.high * half.high,
                 restOfSquare = 0.5 * half.low * (r.high + half.high) + r.high * r.low;
    const double r1 = r.high, r2 = r1 * r1;
    const double more =
        r1 * r2 *
        ((1.0 / 3.0 - r1 * (1.0 / 4.0)) +
         r2 * ((1.0 / 5.0 - r1 * (1.0 / 6.0)) + r2 * ((1.0 / 7.0 - r1 * (1.0 / 8.0)) + r2 * (1.0 / 9.0))));
    const Precise first = orderedSum(parts.highLog(), r.high), second = orderedSum(first.high, -square);
    return orderedSum(second.high,
                      second.low + (first.low + (parts.lowLog() + r.low + (more - restOfSquare))));
}

/// Whether `log` of <cmath> has no rounded result; sets it.
bool isSpecialLog(double x, double& result) {
    if (x > 0.0 && x < infinity)
        return false;
    result = x == 0.0 ? -infinity : x < 0.0 ? notANumber : x; // infinity or NaN
    return true;
}

/// An angle in [-pi/4, pi/4], and how many right angles were taken away.
struct Turn {
    Precise rest;
    int quadrant;
};
Turn turnOf(double angle) {
    if (std::fabs(angle) <= 0.78)
        return {{angle}, 0};
    if (std::fabs(angle) > 0x1p30)
        angle = std::fmod(angle, 2.0 * pi.high); // NaN if it is infinite
    if (std::isnan(angle))
        return {{angle}, 0};
    // pi / 2 in parts of 23 bits, so that multiples of them are exact (Cody and Waite 1980), and the rest.
    constexpr double first = 0x1.921fb4p+0;
    constexpr double parts[] = {0x1.4442dp-24, 0x1.84698p-48, 0x1.3198ap-69, 0x1.701b839a25205p-92};
    const double turns = nearest(angle * perHalfPi);
    Precise rest{angle - turns * first};
    for (const double part : parts) {
        const Precise next = sum(rest.high, -turns * part);
        rest = {next.high, rest.low + next.low};
    }
    return {orderedSum(rest.high, rest.low), static_cast<int>(static_cast<std::int64_t>(turns) & 3)};
}

/// (sin a - a) / a^3 and (cos a - 1 + a^2 / 2) / a^4 of an angle in [-pi/4, pi/4], with Taylor's series.
/// @param z a^2
double restOfSine(double z) {
    const double z2 = z * z;
    return ((-1.0 / 6.0 + z * (1.0 / 120.0)) + z2 * (-1.0 / 5040.0 + z * (1.0 / 362880.0))) +
           z2 * z2 *
               ((-1.0 / 39916800.0 + z * (1.0 / 6227020800.0)) +
                z2 * (-1.0 / 1307674368000.0 + z * (1.0 / 355687428096000.0)));
}
double restOfCosine(double z) {
    const double z2 = z * z;
    return ((1.0 / 24.0 - z * (1.0 / 720.0)) + z2 * (1.0 / 40320.0 - z * (1.0 / 3628800.0))) +
           z2 * z2 *
               ((1.0 / 479001600.0 - z * (1.0 / 87178291200.0)) +
                z2 * (1.0 / 20922789888000.0 - z * (1.0 / 6402373705728000.0)));
}

Precise smallSine(const Precise& a) {
    const double z = a.high * a.high;
    return orderedSum(a.high, a.high * z * restOfSine(z) + a.low * (1.0 - 0.5 * z));
}
Precise smallCosine(const Precise& a) {
    const Precise half = halves(a.high);
    const double square = 0.5 * half.high * half.high,
                 restOfSquare = 0.5 * half.low * (a.high + half.high) + a.high * a.low;
    const double z = a.high * a.high;
    const Precise first = orderedSum(1.0, -square);
    return orderedSum(first.high, first.low + (z * z * restOfCosine(z) - restOfSquare));
}
Precise sineOf(const Turn& turn) {
    const Precise sine = turn.quadrant & 1 ? smallCosine(turn.rest) : smallSine(turn.rest);
    return turn.quadrant & 2 ? -sine : sine;
}
Precise cosineOf(const Turn& turn) {
    return sineOf({turn.rest, turn.quadrant + 1});
}

/// The sine of an angle and `quarters` right angles; in double, without its last bits.
float floatSine(float angle, int quarters) {
    constexpr double high = 0x1.921fb544p+0,
                     low = 0x1.0b4611a626331p-34; // pi / 2, whose first multiples are exact
    const double a = angle;
    if (!(std::fabs(a) < 0x1p20))
        return static_cast<float>(sineOf({turnOf(a).rest, turnOf(a).quadrant + quarters}).high);
    const double turns = nearest(a * perHalfPi), r = (a - turns * high) - turns * low, z = r * r;
    const int quadrant = static_cast<int>(turns) + quarters;
    const double sine =
        quadrant & 1 ? 1.0 - (0.5 * z - z * z * restOfCosine(z)) : r * (1.0 + z * restOfSine(z));
    return static_cast<float>(quadrant & 2 ? -sine : sine);
}

/// The angles whose tangents are i / 16, by Euler's series.
constexpr auto arcs = [] {
    std::array<Precise, 17> table{};
    for (std::size_t i = 1; i < table.size(); ++i) {
        const double c = static_cast<double>(i) / 16.0;
        Precise term = Precise{c} / Precise{1.0 + c * c}, angle = term;
        for (int n = 1; n < 110; ++n) {
            term = term * Precise{2.0 * n * c * c} / Precise{(2.0 * n + 1.0) * (1.0 + c * c)};
            angle = angle + term;
        }
        table[i] = angle;
    }
    return table;
}();

/// The angle of (x, y) above the x axis, x and y >= 0 and not both 0.
Precise arc(const Precise& y, const Precise& x) {
    if (y.high > x.high)
        return halfPi - arc(x, y);
    // arctan(y / x) = arctan(c) + arctan((y - c x) / (x + c y))
    const int i = static_cast<int>(16.0 * y.high / x.high + 0.5);
    const Precise c{i / 16.0}, t = (y - c * x) / (x + c * y);
    const double z = t.high * t.high;
    const double more =
        t.high * z * (-1.0 / 3.0 + z * (1.0 / 5.0 + z * (-1.0 / 7.0 + z * (1.0 / 9.0 + z * (-1.0 / 11.0)))));
    const Precise& start = arcs[static_cast<std::size_t>(i)];
    const Precise high = orderedSum(start.high, t.high);
    return orderedSum(high.high, high.low + (start.low + t.low + more));
}

constexpr double tiny = 0x1p-27; ///< Odd functions are linear below.

} // namespace

double sin(double angle) {
    return std::fabs(angle) < tiny ? angle : sineOf(turnOf(angle)).high;
}

double cos(double angle) {
    return cosineOf(turnOf(angle)).high;
}

float exp(float x) {
    const double wide = x;
    if (!(std::fabs(wide) < 200.0))
        return static_cast<float>(exp(wide));
    const double steps = nearest(wide * (stepsPerOctave / ln2.high));
    const double r = (wide - steps * stepHigh) - steps * stepLow, r2 = r * r;
    const double more = r + r2 * (0.5 + r * (1.0 / 6.0) + r2 * (1.0 / 24.0 + r * (1.0 / 120.0)));
    const int whole = static_cast<int>(steps), i = whole & (stepsPerOctave - 1);
    const double power = powersOfTwo[static_cast<std::size_t>(i)].high;
    const auto exponent = static_cast<std::uint64_t>(1023 + (whole - i) / stepsPerOctave);
    return static_cast<float>((power + power * more) * fromBits(exponent << 52));
}

float log(float x) {
    if (!(x > 0.0f && x < std::numeric_limits<float>::infinity()))
        return static_cast<float>(log(static_cast<double>(x)));
    const std::uint64_t bits = bitsOf(x), above = bits - bitsOf(lowestLog);
    const double z = fromBits(bits - (above & 0xfffull << 52));
    const TableLog& entry = logs[static_cast<std::size_t>(static_cast<int>(128.0 * z + 0.5) - firstLog)];
    const double r = z * entry.inverse - 1.0, r2 = r * r;
    const double more =
        r + r2 * ((-1.0 / 2.0 + r * (1.0 / 3.0)) + r2 * (-1.0 / 4.0 + r * (1.0 / 5.0) + r2 * (-1.0 / 6.0)));
    const auto exponent = static_cast<double>(static_cast<std::int64_t>(above) >> 52);
    return static_cast<float>(exponent * ln2.high + (entry.log.high + (entry.log.low + more)));
}

float sin(float angle) {
    return floatSine(angle, 0);
}

float cos(float angle) {
    return floatSine(angle, 1);
}

double tan(double angle) {
    if (std::fabs(angle) < tiny)
        return angle;
    const Turn turn = turnOf(angle);
    return (sineOf(turn) / cosineOf(turn)).high;
}

double asin(double x) {
    const double size = std::fabs(x);
    if (!(size <= 1.0))
        return notANumber;
    return size < tiny ? x : std::copysign(arc({size}, root(Precise{1.0} - product(x, x))).high, x);
}

double acos(double x) {
    const double size = std::fabs(x);
    if (!(size <= 1.0))
        return notANumber;
    const Precise angle = arc(root(Precise{1.0} - product(x, x)), {size});
    return x < 0.0 ? (pi - angle).high : angle.high;
}

double atan(double x) {
    return atan2(x, 1.0);
}

double atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y))
        return notANumber;
    double up = std::fabs(y), along = std::fabs(x);
    const double larger = up > along ? up : along, smaller = up > along ? along : up;
    Precise angle{0.0};
    if (up == infinity && along == infinity)
        angle = arc({1.0}, {1.0});
    else if (larger > 0.0 && smaller / larger < 0x1p-60)
        angle = up > along ? halfPi - Precise{smaller / larger} : Precise{smaller / larger};
    else if (larger > 0.0) {
        if (larger > 0x1p500 || larger < 0x1p-500) { // the products need room
            const int exponent = std::ilogb(larger);
            up = std::ldexp(up, -exponent);
            along = std::ldexp(along, -exponent);
        }
        angle = arc({up}, {along});
    }
    return std::copysign(std::signbit(x) ? (pi - angle).high : angle.high, y);
}

double exp(double x) {
    return exponential({x});
}

double log(double x) {
    double result;
    if (isSpecialLog(x, result))
        return result;
    const Divided parts = divided(x);
    const Precise r = orderedSum(parts.high, parts.low), first = orderedSum(parts.highLog(), r.high);
    const double r1 = r.high, r2 = r1 * r1;
    const double more = r2 * (((-1.0 / 2.0 + r1 * (1.0 / 3.0)) + r2 * (-1.0 / 4.0 + r1 * (1.0 / 5.0))) +
                              r2 * r2 * ((-1.0 / 6.0 + r1 * (1.0 / 7.0)) - r2 * (1.0 / 8.0)));
    return first.high + (first.low + (parts.lowLog() + r.low + more));
}

double log2(double x) {
    constexpr Precise perLn2{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
    double result;
    return isSpecialLog(x, result) ? result : (logarithm(x) * perLn2).high;
}

double log10(double x) {
    constexpr Precise perLn10{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};
    double result;
    return isSpecialLog(x, result) ? result : (logarithm(x) * perLn10).high;
}

double pow(double base, double exponent) {
    if (exponent == 0.0 || base == 1.0)
        return 1.0;
    if (std::isnan(base) || std::isnan(exponent))
        return notANumber;
    const double size = std::fabs(base);
    const bool isWhole = std::trunc(exponent) == exponent;
    double result;
    if (size == 0.0 || size == infinity)
        result = (size == 0.0) == (exponent < 0.0) ? infinity : 0.0;
    else if (size == 1.0 && isWhole)
        result = 1.0;
    else if (base < 0.0 && !isWhole)
        return notANumber;
    else {
        constexpr double most = 0x1p70; // overflows or underflows any base but 1, and its product does not
        const double clamped = exponent > most ? most : exponent < -most ? -most : exponent;
        result = exponential(logarithm(size) * Precise{clamped});
    }
    const bool isOdd = isWhole && std::fabs(exponent) < 0x1p53 && std::fmod(exponent, 2.0) != 0.0;
    return std::signbit(base) && isOdd ? -result : result;
}

double cbrt(double x) {
    if (x == 0.0 || !std::isfinite(x))
        return x;
    constexpr Precise third = Precise{1.0} / Precise{3.0};
    return std::copysign(exponential(logarithm(std::fabs(x)) * third), x);
}

double hypot(double x, double y) {
    x = std::fabs(x);
    y = std::fabs(y);
    if (x == infinity || y == infinity)
        return infinity;
    const double larger = x > y ? x : y;
    if (!(larger > 0.0) || std::isnan(x + y))
        return x + y;
    int exponent = 0;
    if (larger > 0x1p500 || larger < 0x1p-400) { // the squares need room
        exponent = std::ilogb(larger);
        x = std::ldexp(x, -exponent);
        y = std::ldexp(y, -exponent);
    }
    const double length = root(product(x, x) + product(y, y)).high;
    return exponent == 0 ? length : std::ldexp(length, exponent);
}

double erf(double x) {
    const double size = std::fabs(x), z = x * x;
    if (size < 1.0) { // fitted to erf(x) / x - 1
        constexpr double terms[] = {5.957176147748911e-11,   -1.1372848856791674e-09, 1.4659775274047436e-08,
                                    -1.6350312701054695e-07, 1.6461000484121368e-06,  -1.4925595266831182e-05,
                                    0.0001205533111164271,   -0.000854832698083379,   0.0052239776248180145,
                                    -0.026866170645076792,   0.11283791670954879,     -0.3761263890318375,
                                    0.1283791670955126};
        double series = 0.0;
        for (const double term : terms)
            series = series * z + term;
        return x + x * series;
    }
    if (size > 6.0)
        return std::copysign(1.0, x);
    const double t = 4.0 / (4.0 + size); // fitted to (1 - erf(x)) exp(x^2) / t
    constexpr double terms[] = {
        -0.022594217224417307, 0.19258026073634607, -0.7169506354720363,  1.560293566224899,
        -2.306567894146452,    2.5277930664428796,  -2.03839986318667,    1.3622000006541402,
        -0.5929333150179897,   0.3356510377783308,  0.022481928988993694, 0.13250808060886493,
        0.1248847722870673,    0.136982359056067,   0.14102261846659406,  0.14104823307076603};
    double series = 0.0;
    for (const double term : terms)
        series = series * t + term;
    return std::copysign(1.0 - exp(-z) * t * series, x);
}

} // namespace osgTreeWind::math
