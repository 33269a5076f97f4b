// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace osgTreeWind {

/// Parses an ISO 8601 date and time, "2015-06-29T12:00[:00[.5]][Z|+01:00]". A blank may replace the T; the
/// default zone is UTC. @return seconds since 1970-01-01T00:00Z; empty for invalid text, days or hours.
std::optional<double> parseIsoTime(std::string_view text);

/// Formats seconds since 1970-01-01T00:00Z, truncated to whole seconds, as "2017-06-03T18:00:00Z".
std::string isoTimeText(double seconds);

} // namespace osgTreeWind
