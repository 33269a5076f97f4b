// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace osgTreeWind {

struct CfDate {
    int year = 1970, month = 1, day = 1;
};

/// A calendar of the CF conventions: its dates, counted in days from 1970-01-01 of the Gregorian one, or from
/// its own 1 January 0000 where its years have another length.
class CfCalendar {
public:
    /// "standard", "noleap", "360_day", ...; nothing for none of these. An empty text is the standard one.
    static std::optional<CfCalendar> named(const std::string& name);

    /// Whether its days are those that we live by.
    bool isUsual() const { return _kind == Kind::Standard || _kind == Kind::Proleptic; }
    bool has(const CfDate& date) const;
    std::int64_t dayOf(const CfDate& date) const;
    CfDate dateOf(std::int64_t day) const;

private:
    enum class Kind { Standard, Proleptic, NoLeap, AllLeap, Days360 };

    explicit CfCalendar(Kind kind) : _kind(kind) {}
    int daysIn(int year, int month) const;
    bool isJulian(const CfDate& date) const;

    Kind _kind;
};

} // namespace osgTreeWind
