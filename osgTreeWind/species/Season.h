// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/species/Appearance.h>

#include <optional>
#include <string>

namespace osgTreeWind {

// A season is a number: 0 in midwinter (4 February), 1 in midspring (6 May), 2 in midsummer (6 August), 3 in
// midautumn (5 November) of the temperate north, and linear in days. 4 is the same as 0.
constexpr float midwinter = 0.0f, midspring = 1.0f, midsummer = 2.0f, midautumn = 3.0f;

/// The same season in [0, 4); midsummer if it is not finite.
OSGTREEWIND_EXPORT float wrapSeason(float season);

/// Texts that parseSeason() accepts, for messages.
constexpr const char* seasonSyntax =
    "winter, spring, summer, autumn, a number from 0 to 4 or a date such as 2024-11-05";
/// Parses a season: "winter", "spring", "summer", "autumn", a number from 0 to 4, or a date such as
/// "2024-11-05". Nullopt for any other text.
OSGTREEWIND_EXPORT std::optional<float> parseSeason(const std::string& text);

/// Share of its leaves that a tree bears, 0 to 1; always 1 for an evergreen.
OSGTREEWIND_EXPORT float leafShare(const Appearance& appearance, float season);
/// Mean colour of the leaves in a season, linear RGB. Half of the foliage of an evergreen is on shoots of
/// this year.
OSGTREEWIND_EXPORT glm::vec3 leafColor(const Appearance& appearance, float season);
/// Colour of the leaves at the ends of twigs, on shoots of this year. In spring, those of evergreens are
/// paler and yellower than the others.
OSGTREEWIND_EXPORT glm::vec3 shootColor(const Appearance& appearance, float season);

} // namespace osgTreeWind
