// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/IsoTime.h>

#include <cstdint>

namespace osgTreeWind {

namespace {

/// Takes a text apart from its front; once a piece is missing, `ok` stays false.
class Scanner {
public:
    explicit Scanner(std::string_view text) : _rest(text) {}

    bool ok = true;

    bool atEnd() const { return _rest.empty(); }

    /// Whether the next character is one of `choices`; it is taken.
    bool accept(std::string_view choices) {
        if (_rest.empty() || choices.find(_rest.front()) == std::string_view::npos)
            return false;
        _rest.remove_prefix(1);
        return true;
    }

    void expect(std::string_view choices) { ok = accept(choices) && ok; }

    /// A whole number of exactly `digits` digits within [low, high].
    int number(int digits, int low, int high) {
        int value = 0;
        for (int i = 0; i < digits; ++i)
            value = value * 10 + digit();
        ok = ok && value >= low && value <= high;
        return value;
    }

    /// The digits after a decimal point.
    double fraction() {
        double value = 0.0, weight = 0.1;
        ok = ok && isDigit();
        for (; ok && isDigit(); weight *= 0.1)
            value += weight * digit();
        return value;
    }

private:
    bool isDigit() const { return !_rest.empty() && _rest.front() >= '0' && _rest.front() <= '9'; }

    int digit() {
        ok = ok && isDigit();
        if (!ok)
            return 0;
        const int value = _rest.front() - '0';
        _rest.remove_prefix(1);
        return value;
    }

    std::string_view _rest;
};

int daysInMonth(int year, int month) {
    constexpr int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return month == 2 && leap ? 29 : days[month - 1];
}

/// Days from 1970-01-01 in the proleptic Gregorian calendar, counted in years that begin in March.
std::int64_t daysSinceEpoch(int year, int month, int day) {
    const int y = month > 2 ? year : year - 1;
    const int monthFromMarch = (month + 9) % 12;
    const int dayOfYear = (153 * monthFromMarch + 2) / 5 + day - 1;
    const auto leapDays = [](int years) { return years / 4 - years / 100 + years / 400; };
    constexpr int daysFromYearZeroToEpoch = 719468;
    return std::int64_t{365} * y + leapDays(y) + dayOfYear - daysFromYearZeroToEpoch;
}

} // namespace

std::optional<double> parseIsoTime(std::string_view text) {
    Scanner scan(text);
    const int year = scan.number(4, 1, 9999);
    scan.expect("-");
    const int month = scan.number(2, 1, 12);
    scan.expect("-");
    const int day = scan.number(2, 1, 31);
    if (!scan.ok || day > daysInMonth(year, month))
        return std::nullopt;

    scan.expect("Tt ");
    const int hour = scan.number(2, 0, 23);
    scan.expect(":");
    const int minute = scan.number(2, 0, 59);
    double second = 0.0;
    if (scan.accept(":")) {
        second = scan.number(2, 0, 59);
        if (scan.accept("."))
            second += scan.fraction();
    }

    int zoneMinutes = 0;
    if (!scan.accept("Zz") && !scan.atEnd()) {
        const int sign = scan.accept("-") ? -1 : 1;
        if (sign > 0)
            scan.expect("+");
        zoneMinutes = scan.number(2, 0, 23) * 60;
        scan.expect(":");
        zoneMinutes = sign * (zoneMinutes + scan.number(2, 0, 59));
    }
    if (!scan.ok || !scan.atEnd())
        return std::nullopt;
    return daysSinceEpoch(year, month, day) * 86400.0 + hour * 3600.0 + (minute - zoneMinutes) * 60.0 +
           second;
}

} // namespace osgTreeWind
