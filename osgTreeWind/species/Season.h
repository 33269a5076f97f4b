// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/species/Appearance.h>

#include <optional>
#include <string>

namespace osgTreeWind {

// A season is a number: 0 the middle of winter (4 February), 1 of spring (5 May), 2 of summer (6 August), 3
// of autumn (5 November) in the temperate north; 4 is 0 again. What lies between them is even in days.
constexpr float midwinter = 0.0f, midspring = 1.0f, midsummer = 2.0f, midautumn = 3.0f;

/// The same time of the year in [0, 4); midsummer for what is not finite.
OSGTREEWIND_EXPORT float withinYear(float season);

/// What parseSeason() takes.
constexpr const char* seasonForms =
    "winter, spring, summer, autumn, a number from 0 to 4 or a date such as 2024-11-05";
/// "winter", "spring", "summer" or "autumn", a number from 0 to 4, or a date such as "2024-11-05". Nothing
/// for any other text.
OSGTREEWIND_EXPORT std::optional<float> parseSeason(const std::string& text);

/// Share of its leaves that a tree bears: all of them in summer, and an evergreen always.
OSGTREEWIND_EXPORT float leafShare(const Appearance& appearance, float season);
/// Of the leaves it bears, linear RGB: fresh in spring, as they are in summer, turned in autumn.
OSGTREEWIND_EXPORT glm::vec3 leafColor(const Appearance& appearance, float season);

} // namespace osgTreeWind
