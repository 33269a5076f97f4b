// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/Season.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/species/SeasonDay.h>

#include <glm/common.hpp>

#include <array>
#include <cmath>
#include <cstdio>

namespace osgTreeWind {

float wrapSeason(float season) {
    const float rest = season - 4.0f * std::floor(0.25f * season);
    return rest >= 0.0f && rest < 4.0f ? rest : midsummer; // NaN fails the comparisons
}

namespace {

// Dates when leaves unfold, turn and fall: means of oak, beech, birch and horse chestnut in Central Europe
// from the PEP725 network (Menzel et al. 2006: first leaves 15 April to 2 May, half of them fallen about 1
// November). Durations in a crown: PhenoCam's greenness curves (Richardson et al. 2018: five weeks in spring,
// six to eight in autumn).
constexpr float budBurst = 0.75f, fullyUnfolded = 1.15f; // 12 April, 18 May
constexpr float hardening = 1.0f, hardened = 1.5f;       // 5 May, 20 June: leaves darken
constexpr float shootsHarden = 1.25f;                    // 28 May; those of evergreens do until midsummer
constexpr float turning = 2.45f, turned = 2.85f;         // 16 September, 23 October
constexpr float falling = 2.7f, allFallen = 3.25f;       // 9 October, 28 November

std::optional<float> seasonOfDate(const std::string& text) {
    int year = 0, month = 0, day = 0, end = 0;
    const bool read = std::sscanf(text.c_str(), "%4d-%2d-%2d%n", &year, &month, &day, &end) == 3;
    constexpr std::array<int, 13> daysBefore = {0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334, 365};
    if (!read || text.size() != 10 || end != 10 || month < 1 || month > 12 || day < 1)
        return {};
    const auto before = static_cast<std::size_t>(month - 1);
    const int leapDay = month == 2 && (year % 4 == 0 && (year % 100 != 0 || year % 400 == 0));
    if (day > daysBefore[before + 1] - daysBefore[before] + leapDay)
        return {};
    return seasonOfDay(daysBefore[before] + day - 1);
}

} // namespace

std::optional<float> parseSeason(const std::string& text) {
    if (text == "winter")
        return midwinter;
    if (text == "spring")
        return midspring;
    if (text == "summer")
        return midsummer;
    if (text == "autumn")
        return midautumn;
    if (const std::optional<double> number = parseNumber(text))
        return *number >= 0.0 && *number <= 4.0 ? std::optional(static_cast<float>(*number)) : std::nullopt;
    return seasonOfDate(text);
}

float leafShare(const Appearance& appearance, float season) {
    if (appearance.isEvergreen())
        return 1.0f;
    const float now = wrapSeason(season);
    return now < midsummer ? glm::smoothstep(budBurst, fullyUnfolded, now)
                           : 1.0f - glm::smoothstep(falling, allFallen, now);
}

glm::vec3 leafColor(const Appearance& appearance, float season) {
    if (appearance.isEvergreen())
        return 0.5f * (appearance.leaves + shootColor(appearance, season));
    const float now = wrapSeason(season);
    if (now < midsummer)
        return glm::mix(appearance.springLeaves, appearance.leaves,
                        glm::smoothstep(hardening, hardened, now));
    return glm::mix(appearance.leaves, appearance.autumnLeaves, glm::smoothstep(turning, turned, now));
}

glm::vec3 shootColor(const Appearance& appearance, float season) {
    if (!appearance.isEvergreen())
        return leafColor(appearance, season);
    constexpr glm::vec3 yellower{1.3f, 1.15f, 0.7f}; // without the wax of old needles
    const float now = wrapSeason(season), unfolded = glm::smoothstep(budBurst, fullyUnfolded, now),
                soft = 1.0f - glm::smoothstep(shootsHarden, midsummer, now);
    return appearance.leafForm == LeafForm::Frond
               ? appearance.leaves
               : glm::mix(appearance.leaves, yellower * appearance.springLeaves, unfolded * soft);
}

} // namespace osgTreeWind
