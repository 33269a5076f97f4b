// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Unicode.h>

#include <algorithm>
#include <cwctype>
#include <utility>

#include <locale.h>

namespace osgTreeWind {

namespace {

constexpr char32_t replacement = 0xfffd;

/// Removes the first character of a UTF-8 text. @return it, or `replacement` for an invalid byte.
char32_t takeCharacter(std::string_view& text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80    ? 1
                               : first > 0xf4  ? 0
                               : first >= 0xf0 ? 4
                               : first >= 0xe0 ? 3
                               : first >= 0xc2 ? 2
                                               : 0;
    constexpr unsigned char firstBits[] = {0, 0x7f, 0x1f, 0x0f, 0x07};
    constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    char32_t character = first & firstBits[length];
    bool isValid = length > 0 && length <= text.size();
    for (std::size_t i = 1; isValid && i < length; ++i) {
        isValid = (byte(i) & 0xc0) == 0x80;
        character = character << 6 | (byte(i) & 0x3f);
    }
    isValid = isValid && character >= least[length] && character <= 0x10ffff &&
              (character < 0xd800 || character > 0xdfff);
    text.remove_prefix(isValid ? length : 1);
    return isValid ? character : replacement;
}

void append(std::string& text, char32_t character) {
    const auto add = [&](char32_t bits) { text += static_cast<char>(bits); };
    if (character < 0x80)
        return add(character);
    if (character < 0x800) {
        add(0xc0 | character >> 6);
    } else if (character < 0x10000) {
        add(0xe0 | character >> 12);
        add(0x80 | (character >> 6 & 0x3f));
    } else {
        add(0xf0 | character >> 18);
        add(0x80 | (character >> 12 & 0x3f));
        add(0x80 | (character >> 6 & 0x3f));
    }
    add(0x80 | (character & 0x3f));
}

/// The characters 0x80 to 0x9f of Windows-1252; 0: unassigned.
constexpr char16_t windows1252[32] = {0x20ac, 0,      0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021,
                                      0x02c6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017d, 0,
                                      0,      0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014,
                                      0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0,      0x017e, 0x0178};

std::string fromWindows1252(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 8);
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        const char32_t special = byte >= 0x80 && byte < 0xa0 ? windows1252[byte - 0x80] : byte;
        append(text, special != 0 ? special : replacement);
    }
    return text;
}

std::string fromUtf16(std::string_view bytes, bool bigEndian) {
    const auto unit = [&](std::size_t at) {
        const auto first = static_cast<unsigned char>(bytes[at]),
                   second = static_cast<unsigned char>(bytes[at + 1]);
        return static_cast<char32_t>(bigEndian ? first << 8 | second : second << 8 | first);
    };
    std::string text;
    for (std::size_t at = 2; at + 1 < bytes.size(); at += 2) {
        char32_t character = unit(at);
        const bool isHigh = character >= 0xd800 && character < 0xdc00;
        const char32_t low = isHigh && at + 3 < bytes.size() ? unit(at + 2) : 0;
        if (low >= 0xdc00 && low < 0xe000) {
            character = 0x10000 + ((character - 0xd800) << 10) + (low - 0xdc00);
            at += 2;
        }
        append(text, character >= 0xd800 && character < 0xe000 ? replacement : character);
    }
    return text;
}

/// Base letters of accented Latin letters.
struct BaseLetters {
    char32_t character;
    const char* letters;
};
constexpr BaseLetters baseLetterTable[] = {
    {0xdf, "ss"}, {0xe6, "a"},  {0xe7, "c"},  {0xf0, "d"},  {0xf1, "n"},  {0xf8, "o"},  {0xfe, "th"},
    {0xfd, "y"},  {0xff, "y"},  {0x107, "c"}, {0x10d, "c"}, {0x10f, "d"}, {0x111, "d"}, {0x119, "e"},
    {0x11b, "e"}, {0x11f, "g"}, {0x131, "i"}, {0x142, "l"}, {0x144, "n"}, {0x148, "n"}, {0x151, "o"},
    {0x153, "o"}, {0x159, "r"}, {0x15b, "s"}, {0x15f, "s"}, {0x161, "s"}, {0x165, "t"}, {0x16f, "u"},
    {0x171, "u"}, {0x17a, "z"}, {0x17c, "z"}, {0x17e, "z"}, {0x103, "a"}, {0x105, "a"}, {0x163, "t"},
    {0x219, "s"}, {0x21b, "t"}};

std::string baseLetters(char32_t character) {
    if (character >= 0xe0 && character <= 0xe5)
        return "a";
    if (character >= 0xe8 && character <= 0xeb)
        return "e";
    if (character >= 0xec && character <= 0xef)
        return "i";
    if (character >= 0xf2 && character <= 0xf6)
        return "o";
    if (character >= 0xf9 && character <= 0xfc)
        return "u";
    for (const BaseLetters& entry : baseLetterTable)
        if (entry.character == character)
            return entry.letters;
    std::string text;
    append(text, character);
    return text;
}

char32_t lowerCase(char32_t character) {
    if (character < 0x80)
        return character >= 'A' && character <= 'Z' ? character + ('a' - 'A') : character;
    static const locale_t unicode = newlocale(LC_CTYPE_MASK, "C.UTF-8", locale_t());
    return unicode ? static_cast<char32_t>(towlower_l(static_cast<wint_t>(character), unicode)) : character;
}

/// Includes control characters and zero-width spaces.
bool isBlank(char32_t c) {
    return c <= ' ' || c == 0xa0 || (c >= 0x2000 && c <= 0x200d) || c == 0x2028 || c == 0x2029 ||
           c == 0x202f || c == 0x205f || c == 0x3000 || c == 0xfeff;
}

/// Hyphens and dashes, apostrophes, and combining accents.
bool isIgnored(char32_t c) {
    return c == '-' || c == '\'' || c == '`' || c == 0xad || c == 0xb4 || (c >= 0x300 && c <= 0x36f) ||
           (c >= 0x2010 && c <= 0x2019);
}

} // namespace

bool isUtf8(std::string_view bytes) {
    for (;;) {
        const auto next =
            std::find_if(bytes.begin(), bytes.end(), [](char c) { return static_cast<signed char>(c) < 0; });
        bytes.remove_prefix(static_cast<std::size_t>(next - bytes.begin()));
        if (bytes.empty())
            return true;
        const bool isReplacement = bytes.substr(0, 3) == "\xef\xbf\xbd";
        if (takeCharacter(bytes) == replacement && !isReplacement)
            return false;
    }
}

DecodedText decodeText(std::string bytes) {
    if (bytes.compare(0, 2, "\xff\xfe") == 0 || bytes.compare(0, 2, "\xfe\xff") == 0)
        return {fromUtf16(bytes, bytes[0] == '\xfe'), {}};
    if (isUtf8(bytes))
        return {std::move(bytes), {}};
    return {fromWindows1252(bytes), "Windows-1252"};
}

std::string foldedName(std::string_view text) {
    std::string name;
    bool isBlankPending = false;
    while (!text.empty()) {
        const char32_t character = lowerCase(takeCharacter(text));
        if (isBlank(character)) {
            isBlankPending = !name.empty();
            continue;
        }
        if (isBlankPending)
            name += ' ';
        isBlankPending = false;
        append(name, character);
    }
    return name;
}

std::string comparableName(std::string_view text) {
    std::string name;
    while (!text.empty()) {
        const char32_t character = lowerCase(takeCharacter(text));
        if (isBlank(character) || isIgnored(character))
            continue;
        const std::string letters = baseLetters(character);
        const bool isUmlautE = letters == "e" && !name.empty() &&
                               std::string_view("aou").find(name.back()) != std::string_view::npos;
        if (!isUmlautE)
            name += letters;
    }
    return name;
}

} // namespace osgTreeWind
