// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/NameMatching.h>

#include <algorithm>
#include <numeric>

namespace osgTreeWind {

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

std::string nearestName(const std::string& word, const std::vector<std::string>& words) {
    constexpr std::size_t maxLength = 60;
    std::string best;
    std::size_t smallest = std::max<std::size_t>(std::min(maxLength, word.size()) / 3, 1);
    for (const std::string& candidate : words) {
        const std::size_t distance = word.size() > maxLength ? maxLength : editDistance(word, candidate);
        if (distance <= smallest && distance < std::max(word.size(), candidate.size())) {
            smallest = distance;
            best = candidate;
        }
    }
    return best;
}

} // namespace osgTreeWind
