// SPDX-License-Identifier: MIT
#include <plugins/weather/GribEditions.h>
#include <plugins/weather/GribTime.h>

#include <cmath>

namespace osgTreeWind::GribEditions {

namespace {

struct GridKind {
    int number;
    const char* name;
    std::size_t flagsAt; ///< 0: its points are not even.
};

constexpr GridKind gridKinds[] = {{0, "latitude and longitude", 55},
                                  {1, "rotated latitude and longitude", 0},
                                  {2, "stretched latitude and longitude", 0},
                                  {10, "Mercator", 47},
                                  {12, "transverse Mercator", 47},
                                  {20, "polar stereographic", 47},
                                  {30, "Lambert conformal", 47},
                                  {31, "Albers", 47},
                                  {40, "Gaussian", 0},
                                  {41, "rotated Gaussian", 0},
                                  {50, "spherical harmonics", 0},
                                  {90, "space view", 0},
                                  {101, "unstructured", 0},
                                  {140, "Lambert azimuthal equal area", 55},
                                  {204, "curvilinear", 0}};

GribLevelKind levelKindOf(int type) {
    switch (type) {
    case 1:
        return GribLevelKind::Surface;
    case 100:
        return GribLevelKind::Isobaric;
    case 102:
        return GribLevelKind::AboveSea;
    case 103:
        return GribLevelKind::AboveGround;
    case 105: // hybrid
    case 111: // eta
    case 118: // hybrid height
    case 119: // hybrid pressure
    case 150: // height that follows the ground
        return GribLevelKind::Model;
    default:
        return GribLevelKind::Other;
    }
}

GribLevel levelOf2(const GribBytes& section) {
    constexpr int none = 255;
    GribLevel level{levelKindOf(section.whole(23)), section.whole(23), 0.0};
    if (section.number(25, 4) != 0xffffffff)
        level.value = section.withSign(25, 4) * std::pow(10.0, -section.withSign(24, 1));
    if (section.whole(29) != none && level.kind != GribLevelKind::Model)
        level.kind = GribLevelKind::Other; // from one level to another
    return level;
}

} // namespace

Problem readOrigin2(const GribBytes& section, GribField& field) {
    if (section.size() < 21)
        return "section 1 has " + std::to_string(section.size()) + " bytes; expected at least 21";
    field.parameter.centre = section.whole(6, 2);
    const auto reference = GribTime::secondsOf({section.whole(13, 2), section.whole(15), section.whole(16),
                                                section.whole(17), section.whole(18), section.whole(19)});
    if (!reference)
        return "section 1 has a date that does not exist";
    field.reference = *reference;
    return {};
}

Problem readGrid2(const GribBytes& section, GribField& field) {
    if (section.size() < 14)
        return "section 3 has " + std::to_string(section.size()) + " bytes; expected at least 14";
    const int number = section.whole(13, 2);
    GribGrid& grid = field.grid;
    grid = {"template " + std::to_string(number), false, false, 0, 0, {}};
    grid.definition = '2' + std::string(section.bytes().substr(5));
    grid.columns = section.number(31, 4);
    grid.rows = section.number(35, 4);
    for (const GridKind& kind : gridKinds)
        if (kind.number == number) {
            grid.kind = kind.name;
            grid.even = kind.flagsAt > 0;
            if (!grid.even)
                continue;
            if (section.size() < kind.flagsAt)
                return "section 3 has " + std::to_string(section.size()) + " bytes; expected at least " +
                       std::to_string(kind.flagsAt);
            grid.relativeToGrid = section.whole(kind.flagsAt) & toGridFlag;
            grid.definition[1 + kind.flagsAt - 6] =
                static_cast<char>(section.whole(kind.flagsAt) & ~toGridFlag);
        }
    if (section.whole(11) != 0 || grid.columns == 0xffffffff || grid.rows == 0xffffffff) {
        grid.even = false; // rows of different lengths
        grid.kind = "reduced " + grid.kind;
    }
    return {};
}

Problem readProduct2(const GribBytes& section, GribField& field) {
    if (section.size() < 9)
        return "section 4 has " + std::to_string(section.size()) + " bytes; expected at least 9";
    const int number = section.whole(8, 2);
    field.parameter.category = section.whole(10);
    field.parameter.number = section.whole(11);
    field.momentary = false;
    field.level = {};
    field.valid = field.reference;
    constexpr int lastMomentary = 2; // a forecast, that of a member, one made of all members
    if (number > lastMomentary)
        return {};
    if (section.size() < 34)
        return "section 4 has " + std::to_string(section.size()) + " bytes; expected at least 34";
    field.level = levelOf2(section);
    if (const auto unit = GribTime::secondsOfUnit(2, section.whole(18))) {
        field.momentary = true;
        field.valid += *unit * section.withSign(19, 4);
    }
    return {};
}

void readPacking2(const GribBytes& section, GribField& field) {
    constexpr int png = 41, ownPng = 40010, ccsds = 42;
    const int number = section.whole(10, 2), bits = section.whole(20);
    const bool isPng = number == png || number == ownPng;
    field.packing = number == ccsds ? "by CCSDS" : isPng ? "as PNG" : "by template " + std::to_string(number);
    field.unpackable = !isPng || bits <= 1 || bits == 2 || bits == 4 || bits % 8 == 0; // as PNG has them
}

} // namespace osgTreeWind::GribEditions
