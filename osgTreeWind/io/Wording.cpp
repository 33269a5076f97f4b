// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/Wording.h>

#include <algorithm>
#include <numeric>

namespace osgTreeWind {

std::string printable(std::string text) {
    constexpr std::size_t longest = 200;
    if (text.size() > longest) {
        std::size_t end = longest;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80)
            --end; // never half a UTF-8 character
        text = text.substr(0, end) + "...";
    }
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return text;
}

std::string inQuotes(const std::string& text) {
    return '"' + printable(text) + '"';
}

std::string joined(const std::vector<std::string>& words) {
    std::string result;
    for (const std::string& word : words)
        result += (result.empty() ? "" : ", ") + printable(word);
    return result;
}

std::string alternatives(const std::vector<std::string>& words) {
    std::string result;
    for (std::size_t i = 0; i < words.size(); ++i)
        result += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + inQuotes(words[i]);
    return result;
}

namespace {

std::size_t editDistance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t change = diagonal + (a[i] != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({change, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

} // namespace

std::string nearest(const std::string& word, const std::vector<std::string>& words) {
    constexpr std::size_t longest = 60;
    std::string best;
    std::size_t smallest = std::max<std::size_t>(std::min(longest, word.size()) / 3, 1);
    for (const std::string& candidate : words) {
        const std::size_t distance = word.size() > longest ? longest : editDistance(word, candidate);
        if (distance <= smallest && distance < std::max(word.size(), candidate.size())) {
            smallest = distance;
            best = candidate;
        }
    }
    return best;
}

std::string folded(const std::string& text) {
    const std::string blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string::npos)
        return {};
    std::string result = text.substr(first, text.find_last_not_of(blanks) - first + 1);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return result;
}

} // namespace osgTreeWind
