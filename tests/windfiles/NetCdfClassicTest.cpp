// SPDX-License-Identifier: MIT
// Headers of classic NetCDF, written word by word (NetCDF Classic Format Specification).
#include <osgTreeWind/windfiles/NetCdfClassic.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

using namespace osgTreeWind;

namespace {

std::string words(const std::vector<std::uint32_t>& numbers) {
    std::string bytes;
    for (const std::uint32_t number : numbers)
        for (int shift = 24; shift >= 0; shift -= 8)
            bytes += static_cast<char>((number >> shift) & 0xffu);
    return bytes;
}

/// A file of one variable u on dimensions t, which grows, and x of length 3.
std::string header(const std::vector<std::uint32_t>& dimensions, std::uint32_t type) {
    const std::uint32_t dimensionList = 10, variableList = 11, absent = 0;
    std::string bytes = "CDF\1" + words({0, dimensionList, 2, 1}) + std::string("t\0\0\0", 4) +
                        words({0, 1}) + std::string("x\0\0\0", 4) +
                        words({3, absent, 0, variableList, 1, 1}) + std::string("u\0\0\0", 4) +
                        words({static_cast<std::uint32_t>(dimensions.size())});
    return bytes + words(dimensions) + words({absent, 0, type, 12, 100});
}

constexpr std::uint32_t floats = 5;

} // namespace

TEST(NetCdfClassic, AHeaderThatAddsUpIsGood) {
    EXPECT_EQ(problemOfNetCdfHeader(header({0, 1}, floats)), "");
    EXPECT_EQ(problemOfNetCdfHeader(header({1}, floats)), "");
    EXPECT_EQ(problemOfNetCdfHeader(header({}, floats)), "");
}

TEST(NetCdfClassic, TypesThatAreNoneAreRefused) {
    // libnetcdf divides by their size, 0: found by fuzzing.
    for (const std::uint32_t type : {0u, 12u, 255u, 0x80000005u})
        EXPECT_NE(problemOfNetCdfHeader(header({0, 1}, type)).find("damaged at byte"), std::string::npos);
}

TEST(NetCdfClassic, OnlyAFirstDimensionMayGrow) {
    EXPECT_NE(problemOfNetCdfHeader(header({1, 0}, floats)), "");
    EXPECT_NE(problemOfNetCdfHeader(header({0, 1, 0}, floats)), "");
}

TEST(NetCdfClassic, DimensionsMustBeThere) {
    EXPECT_NE(problemOfNetCdfHeader(header({2}, floats)), "");
    EXPECT_NE(problemOfNetCdfHeader(header({0, 0xffffffffu}, floats)), "");
}

TEST(NetCdfClassic, CutAnywhereItIsDamaged) {
    const std::string whole = header({0, 1}, floats);
    for (std::size_t length = 4; length < whole.size(); ++length)
        EXPECT_NE(problemOfNetCdfHeader(whole.substr(0, length)), "") << length;
}
