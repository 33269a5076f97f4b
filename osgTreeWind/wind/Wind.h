// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/wind/WindAdjustment.h>
#include <osgTreeWind/wind/WindClock.h>
#include <osgTreeWind/wind/WindField.h>
#include <osgTreeWind/wind/WindGusts.h>
#include <osgTreeWind/wind/WindSource.h>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace osgTreeWind {

struct WindFiles;

/// The coordinate frame of a wind's places and velocities, and its vertical (docs/coordinates.md).
enum class WindFrame {
    Forest, ///< The forest's frame, metres from its origin: transforms above the forest move the wind, too.
    Scene,  ///< The scene's root, z up. If the forest is nearer to its origin than to the scene's zero:
            ///< world coordinates minus the forest's origin.
    Geocentric ///< The root of a scene that is a globe: up is the forest's z axis.
};

/// A wind as a value: a field, and the modifications applied to it in the order of the members.
///
///     Wind wind(std::make_shared<UniformWind>(glm::vec3(6, 0, 0)));
///     wind.adjustment.turn = glm::radians(20.0f);
///     wind.gusts.intensity = 0.2;
///     wind.sources.push_back(helicopter);
///     report(forest->setWind(wind));
struct OSGTREEWIND_EXPORT Wind {
    WindFieldPtr field;                 ///< Null: calm.
    WindClock clock;                    ///< Maps scene time to the field's time.
    WindAdjustment adjustment;          ///< Scales and turns velocities.
    WindGusts gusts;                    ///< Adds gusts to the field.
    WindFrame frame = WindFrame::Scene; ///< The frame of the field and of the sources.
    std::vector<WindSource> sources;    ///< Local sources, such as rotors, above and among the trees.

    Wind() = default; ///< Calm.
    /// A field without modifications.
    template <typename Field, typename = std::enable_if_t<std::is_convertible_v<Field*, const WindField*>>>
    Wind(std::shared_ptr<Field> given, WindFrame axes = WindFrame::Scene)
        : field(std::move(given)), frame(axes) {}
    Wind(std::nullptr_t) {} ///< Calm.

    bool isCalm() const { return !field && sources.empty(); } ///< No field and no sources.

private:
    friend const WindFiles* knownOf(const Wind& wind);
    friend void setKnown(Wind& wind, WindFiles known);
    std::shared_ptr<const WindFiles> _known; ///< Of the field that a reader of files has made.
};

/// A wind as a single field, for a forest at the scene's zero; null if calm.
OSGTREEWIND_EXPORT WindFieldPtr asField(const Wind& wind);

/// The problems of a wind's frame and gusts; empty if valid. Adjustments and sources are only clamped.
[[nodiscard]] OSGTREEWIND_EXPORT Diagnostics check(const Wind& wind);

} // namespace osgTreeWind
