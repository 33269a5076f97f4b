// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace osgTreeWind {

/// Seconds since 1970-01-01T00:00Z of an ISO 8601 date and time, "2015-06-29T12:00[:00[.5]][Z|+01:00]",
/// a blank in place of the T allowed, UTC when no zone is given. Empty for any other text, and for days or
/// hours that do not exist.
std::optional<double> parseIsoTime(std::string_view text);

/// The whole of such seconds as such a text: "2017-06-03T18:00:00Z".
std::string isoTimeText(double seconds);

} // namespace osgTreeWind
