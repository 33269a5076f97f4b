// SPDX-License-Identifier: MIT
// Property tests: CSV cells and numbers survive writing and reading.
#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/Number.h>

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace osgTreeWind {

namespace {

/// Random cells with many characters that are special in CSV.
rc::Gen<std::string> cell() {
    return rc::gen::container<std::string>(rc::gen::oneOf(rc::gen::elementOf(std::string(" \t,;\"'\r\n")),
                                                          rc::gen::inRange<char>('!', '~'),
                                                          rc::gen::inRange<char>(-128, -1)));
}

} // namespace

RC_GTEST_PROP(CsvProperty, WrittenLinesReadBackUnchanged, ()) {
    const auto cells = *rc::gen::container<std::vector<std::string>>(3, cell());
    std::istringstream input("a,b,c\n" + csvLine(cells));
    const auto table = readCsvTable(input, "a.csv");
    RC_ASSERT(table.ok());
    RC_ASSERT(table.value().rows.size() == 1u);
    RC_ASSERT(table.value().rows[0].cells == cells);
}

RC_GTEST_PROP(NumberProperty, EveryFiniteNumberReadsBackExactly, (std::uint64_t bits)) {
    double number = 0.0;
    static_assert(sizeof bits == sizeof number);
    std::memcpy(&number, &bits, sizeof number);
    RC_PRE(std::isfinite(number));
    RC_ASSERT(parseNumber(numberText(number)) == number);
}

} // namespace osgTreeWind
