// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Unicode.h>

#include <gtest/gtest.h>

#include <string>

using namespace osgTreeWind;

TEST(Unicode, AcceptsValidUtf8) {
    for (const char* const text : {"", "oak", "\xc2\x80", "ch\xc3\xaane", "\xe0\xa0\x80", "\xed\x9f\xbf",
                                   "\xee\x80\x80", "\xef\xbf\xbd", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"})
        EXPECT_TRUE(isUtf8(text)) << text;
}

TEST(Unicode, RejectsInvalidUtf8) {
    for (const char* const text :
         {"\x80", "a\xbf", "\xc3", "\xe2\x82", "\xf0\x9f\x8c",        // incomplete characters
          "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xf0\x8f\xbf\xbf", // overlong forms
          "\xed\xa0\x80", "\xed\xbf\xbf",                             // surrogates
          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80",                     // beyond the last character
          "\xf8\x88\x80\x80", "\xf9\xaa\x8d\x80", "\xfc\x81\xbb\x9c", "\xfe\x80\x80\x80", "\xff\x80\x80\x80"})
        EXPECT_FALSE(isUtf8(text)) << text;
}

TEST(Unicode, ReadsAnAccentBeforeQuotesAsWindows1252) {
    const DecodedText decoded = decodeText("\xfb\x93\x94\xbb"); // "û“”»"
    EXPECT_EQ(decoded.text, "\xc3\xbb\xe2\x80\x9c\xe2\x80\x9d\xc2\xbb");
    EXPECT_EQ(decoded.assumed, "Windows-1252");
}
