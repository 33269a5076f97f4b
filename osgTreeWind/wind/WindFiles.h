// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/DataTransform.h>
#include <osgTreeWind/wind/Wind.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// The map of a wind's field, the files that it was read from, and the options used, as a forest file stores
/// them.
struct WindFiles {
    WindFieldPtr field;               ///< That this is about; setKnown() sets it.
    std::optional<DataTransform> map; ///< To the data of the field; empty if they are in the scene's CRS.
    std::vector<std::string> files{}; ///< Empty if the field was not read for a forest file.
    bool series = false; ///< Whether the files are time steps (key `files`), even if there is only one.
    std::vector<double> times{}; ///< Time of each file, seconds; empty: the files contain their times.
    glm::dvec3 offset{0.0};      ///< From file to world coordinates, metres.
    glm::dvec3 origin{0.0};      ///< World origin of the forest that the wind was read for.
    std::string crs{};           ///< CRS of that forest.
    double roughness = 0.0;      ///< WindFileOptions::roughness
    double height = 0.0;         ///< WindFileOptions::height
    std::string speedUnit{};     ///< WindFileOptions::speedUnit
    std::vector<std::string> variable{}; ///< WindFileOptions::variable
    bool mayIncludeTrees = false;        ///< WindSummary::mayIncludeTrees
    /// Date of time 0 of the field, seconds since 1970-01-01T00:00Z; empty: unknown.
    std::optional<double> date{};
    bool allowsOutside = false; ///< Whether a forest completely outside the data gets the wind at their edge.
};

/// What is known of the present field of a wind; null if nothing is.
inline const WindFiles* knownOf(const Wind& wind) {
    return wind._known && wind._known->field == wind.field ? wind._known.get() : nullptr;
}
/// Sets what is known of the present field.
inline void setKnown(Wind& wind, WindFiles known) {
    known.field = wind.field;
    wind._known = std::make_shared<const WindFiles>(std::move(known));
}

/// Date of scene time 0, seconds since 1970-01-01T00:00Z; empty: unknown, or the wind's clock runs faster or
/// slower than the scene's.
inline std::optional<double> startDateOf(const Wind& wind) {
    const WindFiles* known = knownOf(wind);
    return known && known->date && wind.clock.scale == 1.0 ? std::optional(*known->date + wind.clock.start)
                                                           : std::nullopt;
}

/// The files that the field was read from; null if it was not read for a forest file.
inline const WindFiles* filesOf(const Wind& wind) {
    const WindFiles* known = knownOf(wind);
    return known && !known->files.empty() ? known : nullptr;
}

/// The transform to the field's data; null if they are in the scene's CRS.
inline const DataTransform* mapOf(const Wind& wind) {
    const WindFiles* known = knownOf(wind);
    return known && known->map ? &*known->map : nullptr;
}

} // namespace osgTreeWind
