// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/EmbeddedTexts.h>
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

TEST(Unicode, ReadsUnassignedBytesOfWindows1252AsReplacements) {
    for (const char* const byte : {"\x81", "\x8d", "\x8f", "\x90", "\x9d"})
        EXPECT_EQ(decodeText(std::string("\xe9") + byte).text, "\xc3\xa9\xef\xbf\xbd") << byte;
}

TEST(Unicode, FoldsCaseOfAllScripts) {
    EXPECT_EQ(foldedName(" SCHÖNE \t Weiß-TANNE "), "schöne weiß-tanne");
    EXPECT_EQ(foldedName("ЁЛКА ΔΡΥΣ ŽÅ"), "ёлка δρυσ žå");
    EXPECT_EQ(foldedName("\xc0Oak"), "\xef\xbf\xbdoak");
}

TEST(Unicode, ComparesLettersWithoutTheirMarks) {
    for (const auto& [letters, base] : {std::pair("ÀÁÂÃÄÅÆàáâãäåæăąā", "a"),
                                        {"Ççćč", "c"},
                                        {"Ððďđ", "d"},
                                        {"Èéêëęě", "e"},
                                        {"ğ", "g"},
                                        {"Ìíîïı", "i"},
                                        {"ł", "l"},
                                        {"Ññńň", "n"},
                                        {"Òóôõöøőœ", "o"},
                                        {"ř", "r"},
                                        {"śşšș", "s"},
                                        {"ß", "ss"},
                                        {"ťţț", "t"},
                                        {"Þþ", "th"},
                                        {"Ùúûüůű", "u"},
                                        {"Ýýÿ", "y"},
                                        {"źżž", "z"}})
        for (std::string_view rest = letters; !rest.empty(); rest.remove_prefix(2))
            EXPECT_EQ(comparableName(rest.substr(0, 2)), base) << rest;
    EXPECT_EQ(comparableName("Roßkastanie"), comparableName("rosskastanie"));
    EXPECT_EQ(comparableName("Bäume"), comparableName("Baeume"));
    EXPECT_EQ(comparableName("a\xcc\x88 l'Arbre–ÉTÉ"), "alarbreete");
    EXPECT_EQ(comparableName("ЙОД が"), "йодが");
}

TEST(Unicode, ComparesAllCommonNamesByPlainLetters) {
    const EmbeddedText* const table = findEmbeddedText("osgTreeWind/species/names.csv");
    ASSERT_TRUE(table);
    std::size_t names = 0;
    EXPECT_TRUE(readCsvRows(table->text, table->name, ',', [&](const CsvTable&, CsvTable::Row& row) {
        for (const std::string& cell : row.cells) {
            const std::string name = comparableName(cell);
            EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz|×."), std::string::npos) << cell;
            ++names;
        }
    }));
    EXPECT_GT(names, 500u);
}
