// SPDX-License-Identifier: MIT
#include <plugins/weather/GribEditions.h>
#include <plugins/weather/GribTime.h>

namespace osgTreeWind::GribEditions {

namespace {

constexpr std::size_t flagsAt = 17; // the same in all definitions that are read

GribLevel levelOf1(const GribBytes& section) {
    GribLevel level{GribLevelKind::Other, section.whole(10), static_cast<double>(section.number(11, 2))};
    switch (level.type) {
    case 1:
        level.kind = GribLevelKind::Surface;
        break;
    case 100:
        level.kind = GribLevelKind::Isobaric;
        level.value *= 100.0; // hPa
        break;
    case 210:
        level.kind = GribLevelKind::Isobaric;
        break;
    case 103:
        level.kind = GribLevelKind::AboveSea;
        break;
    case 105:
        level.kind = GribLevelKind::AboveGround;
        break;
    case 109:
        level.kind = GribLevelKind::Model;
        break;
    case 110: // between two half levels
        level.kind = GribLevelKind::Model;
        level.value = section.whole(11);
        break;
    default:
        break;
    }
    return level;
}

std::string kindOf(int type, bool& even) {
    even = type == 0 || type == 1 || type == 3 || type == 5 || type == 8;
    switch (type) {
    case 0:
        return "latitude and longitude";
    case 1:
        return "Mercator";
    case 3:
        return "Lambert conformal";
    case 4:
        return "Gaussian";
    case 5:
        return "polar stereographic";
    case 8:
        return "Albers";
    case 10:
        return "rotated latitude and longitude";
    case 14:
        return "rotated Gaussian";
    case 50:
        return "spherical harmonics";
    case 90:
        return "space view";
    default:
        return "type " + std::to_string(type);
    }
}

} // namespace

Problem readProduct1(const GribBytes& section, GribField& field) {
    if (section.size() < 28)
        return "section 1 has " + std::to_string(section.size()) + " bytes; expected at least 28";
    field.parameter = {1, section.whole(5), section.whole(4), 0, section.whole(9)};
    field.level = levelOf1(section);
    const int year = section.whole(13);
    const auto reference = GribTime::secondsOf({(section.whole(25) - 1) * 100 + year, section.whole(14),
                                                section.whole(15), section.whole(16), section.whole(17), 0});
    if (!reference)
        return "section 1 has a date that does not exist";
    field.reference = field.valid = *reference;
    constexpr int analysis = 1, ofP1 = 0, ofTwoOctets = 10;
    const int range = section.whole(21);
    const auto unit = GribTime::secondsOfUnit(1, section.whole(18));
    if (range == analysis)
        field.momentary = true;
    else if (unit && (range == ofP1 || range == ofTwoOctets)) {
        field.momentary = true;
        field.valid += *unit * static_cast<double>(section.number(19, range == ofP1 ? 1 : 2));
    }
    return {};
}

Problem readGrid1(const GribBytes& section, GribField& field) {
    if (section.size() < 28)
        return "section 2 has " + std::to_string(section.size()) + " bytes; expected at least 28";
    GribGrid& grid = field.grid;
    grid.kind = kindOf(section.whole(6), grid.even);
    grid.columns = section.number(7, 2);
    grid.rows = section.number(9, 2);
    if (grid.columns == 0xffff || grid.rows == 0xffff) {
        grid.even = false;
        grid.kind = "reduced " + grid.kind;
    }
    grid.relativeToGrid = section.whole(flagsAt) & toGridFlag;
    const int lists = section.whole(4); // of vertical coordinates, which are none of the grid
    const std::size_t listsAt = section.number(5),
                      end = lists > 0 && listsAt > 28 && listsAt != 255 ? listsAt - 1 : section.size();
    grid.definition = '1' + std::string(section.bytes().substr(5, end - 5));
    grid.definition[1 + flagsAt - 6] = static_cast<char>(section.whole(flagsAt) & ~toGridFlag);
    return {};
}

void readPacking1(const GribBytes& section, GribField& field) {
    constexpr int spherical = 0x80, secondOrder = 0x40, moreFlags = 0x10;
    const int flags = section.whole(4);
    field.packing = flags & spherical     ? "as spherical harmonics"
                    : flags & secondOrder ? "by second order"
                    : flags & moreFlags   ? "in a way of its centre's own"
                                          : "simply";
    field.unpackable = !(flags & (spherical | secondOrder | moreFlags));
}

} // namespace osgTreeWind::GribEditions
