// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Unicode.h>

#include <algorithm>
#include <array>
#include <utility>

#include <utf8proc.h>

namespace osgTreeWind {

namespace {

constexpr utf8proc_int32_t replacement = 0xfffd;

/// Removes the first character of a UTF-8 text. @return it, or `replacement` for an invalid byte.
utf8proc_int32_t takeCharacter(std::string_view& text) {
    utf8proc_int32_t character = 0;
    const auto size = utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                                       static_cast<utf8proc_ssize_t>(text.size()), &character);
    text.remove_prefix(size > 0 ? static_cast<std::size_t>(size) : 1);
    return size > 0 ? character : replacement;
}

void append(std::string& text, utf8proc_int32_t character) {
    std::array<utf8proc_uint8_t, 4> bytes{};
    text.append(bytes.begin(), bytes.begin() + utf8proc_encode_char(character, bytes.data()));
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
        const utf8proc_int32_t special = byte >= 0x80 && byte < 0xa0 ? windows1252[byte - 0x80] : byte;
        append(text, special != 0 ? special : replacement);
    }
    return text;
}

std::string fromUtf16(std::string_view bytes, bool bigEndian) {
    const auto unit = [&](std::size_t at) {
        const auto first = static_cast<unsigned char>(bytes[at]),
                   second = static_cast<unsigned char>(bytes[at + 1]);
        return static_cast<utf8proc_int32_t>(bigEndian ? first << 8 | second : second << 8 | first);
    };
    std::string text;
    for (std::size_t at = 2; at + 1 < bytes.size(); at += 2) {
        utf8proc_int32_t character = unit(at);
        const bool isHigh = character >= 0xd800 && character < 0xdc00;
        const utf8proc_int32_t low = isHigh && at + 3 < bytes.size() ? unit(at + 2) : 0;
        if (low >= 0xdc00 && low < 0xe000) {
            character = 0x10000 + ((character - 0xd800) << 10) + (low - 0xdc00);
            at += 2;
        }
        append(text, character >= 0xd800 && character < 0xe000 ? replacement : character);
    }
    return text;
}

/// Base letters of a small Latin letter; the character itself if it is another.
std::string baseLetters(utf8proc_int32_t character) {
    constexpr std::pair<utf8proc_int32_t, const char*> joined[] = {{0xdf, "ss"}, {0xe6, "a"},  {0xf0, "d"},
                                                                   {0xf8, "o"},  {0xfe, "th"}, {0x111, "d"},
                                                                   {0x131, "i"}, {0x142, "l"}, {0x153, "o"}};
    for (const auto& [each, letters] : joined)
        if (each == character)
            return letters;
    std::array<utf8proc_int32_t, 4> parts{};
    int last = 0;
    utf8proc_decompose_char(character, parts.data(), parts.size(), UTF8PROC_DECOMPOSE, &last);
    std::string text;
    append(text, parts[0] < 0x80 ? parts[0] : character);
    return text;
}

/// Includes control characters and zero-width spaces.
bool isBlank(utf8proc_int32_t c) {
    return c <= ' ' || c == 0xa0 || (c >= 0x2000 && c <= 0x200d) || c == 0x2028 || c == 0x2029 ||
           c == 0x202f || c == 0x205f || c == 0x3000 || c == 0xfeff;
}

/// Hyphens and dashes, apostrophes, and combining accents.
bool isIgnored(utf8proc_int32_t c) {
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

std::string asUtf8(std::string text) {
    return isUtf8(text) ? std::move(text) : fromWindows1252(text);
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
        const auto character = utf8proc_tolower(takeCharacter(text));
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
        const auto character = utf8proc_tolower(takeCharacter(text));
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
