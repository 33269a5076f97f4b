// SPDX-License-Identifier: MIT
#include <plugins/weather/GribMeaning.h>

#include <osgTreeWind/base/Number.h>

namespace osgTreeWind::GribMeaning {

namespace {

constexpr double ofGeopotential = 1.0 / 9.80665; // metres per m^2/s^2

/// A parameter of a table.
struct Row {
    long table, category, number;
    Quantity quantity;
    double metres = 1.0;
    double height = 0.0; ///< Height above ground implied by the parameter, metres; 0 if there is none.
};

constexpr long noCategory = 0;

/// Edition 2: by discipline, category, number.
constexpr Row rows2[] = {{0, 2, 2, Quantity::East},
                         {0, 2, 3, Quantity::North},
                         {0, 2, 9, Quantity::Up},
                         {0, 2, 8, Quantity::PressureChange},
                         {0, 2, 1, Quantity::Speed},
                         {0, 2, 0, Quantity::Direction},
                         {0, 3, 5, Quantity::Height},
                         {0, 3, 6, Quantity::Height},
                         {0, 3, 4, Quantity::Height, ofGeopotential},
                         {2, 0, 7, Quantity::Height}};

/// Edition 1: tables 1 to 3, which all centres share.
constexpr Row rows1[] = {{1, noCategory, 33, Quantity::East},
                         {1, noCategory, 34, Quantity::North},
                         {1, noCategory, 40, Quantity::Up},
                         {1, noCategory, 39, Quantity::PressureChange},
                         {1, noCategory, 32, Quantity::Speed},
                         {1, noCategory, 31, Quantity::Direction},
                         {1, noCategory, 7, Quantity::Height},
                         {1, noCategory, 8, Quantity::Height},
                         {1, noCategory, 6, Quantity::Height, ofGeopotential}};

/// Edition 1: tables of ECMWF.
constexpr Row rowsOfEcmwf[] = {{128, noCategory, 131, Quantity::East},
                               {128, noCategory, 132, Quantity::North},
                               {128, noCategory, 135, Quantity::PressureChange},
                               {128, noCategory, 10, Quantity::Speed},
                               {128, noCategory, 156, Quantity::Height},
                               {128, noCategory, 129, Quantity::Height, ofGeopotential},
                               {128, noCategory, 165, Quantity::East, 1.0, 10.0},
                               {128, noCategory, 166, Quantity::North, 1.0, 10.0},
                               {228, noCategory, 246, Quantity::East, 1.0, 100.0},
                               {228, noCategory, 247, Quantity::North, 1.0, 100.0},
                               {228, noCategory, 239, Quantity::East, 1.0, 200.0},
                               {228, noCategory, 240, Quantity::North, 1.0, 200.0}};

template <std::size_t N>
const Row* rowOf(const Row (&rows)[N], long table, long category, long number) {
    for (const Row& row : rows)
        if (row.table == table && row.category == category && row.number == number)
            return &row;
    return nullptr;
}

const Row* rowOf(const GribParameter& parameter) {
    constexpr long ecmwf = 98, lastSharedTable = 3;
    if (parameter.edition == 2)
        return rowOf(rows2, parameter.table, parameter.category, parameter.number);
    if (parameter.table <= lastSharedTable)
        return rowOf(rows1, 1, noCategory, parameter.number);
    return parameter.centre == ecmwf ? rowOf(rowsOfEcmwf, parameter.table, noCategory, parameter.number)
                                     : nullptr;
}

} // namespace

Meaning of(const GribField& field) {
    Meaning meaning;
    meaning.level = field.level;
    const Row* row = rowOf(field.parameter);
    if (!row)
        return meaning;
    meaning.quantity = row->quantity;
    meaning.metres = row->metres;
    if (row->height > 0.0 && field.level.kind == GribLevelKind::Surface)
        meaning.level = {GribLevelKind::AboveGround, field.level.type, row->height};
    return meaning;
}

std::string nameOf(Quantity quantity) {
    constexpr const char* names[] = {
        "no wind", "U", "V", "W", "omega", "wind speed", "wind direction", "geopotential height"};
    return names[static_cast<std::size_t>(quantity)];
}

std::string nameOf(const GribLevel& level) {
    const std::string value = numberText(level.value);
    switch (level.kind) {
    case GribLevelKind::AboveGround:
        return value + " m above ground";
    case GribLevelKind::AboveSea:
        return value + " m above sea level";
    case GribLevelKind::Isobaric:
        return numberText(level.value / 100.0) + " hPa";
    case GribLevelKind::Model:
        return "model level " + value;
    case GribLevelKind::Surface:
        return "the surface";
    default:
        return "level " + value + " of type " + std::to_string(level.type);
    }
}

std::string nameOf(GribLevelKind kind) {
    constexpr const char* names[] = {"heights above ground", "heights above sea level",
                                     "isobaric levels",      "model levels",
                                     "the surface",          "levels of other kinds"};
    return names[static_cast<std::size_t>(kind)];
}

} // namespace osgTreeWind::GribMeaning
