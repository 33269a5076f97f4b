// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/wind/WindAdjustment.h>
#include <osgTreeWind/wind/WindCanopy.h>
#include <osgTreeWind/wind/WindClock.h>
#include <osgTreeWind/wind/WindField.h>
#include <osgTreeWind/wind/WindSource.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace osgTreeWind {

struct WindFiles;
struct WindMap;

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
///     wind.adjustment.turn = 20.0;
///     wind.sources.push_back(helicopter);
///     report(forest->setWind(wind));
struct OSGTREEWIND_EXPORT Wind {
    WindFieldPtr field;                 ///< Null: calm.
    WindClock clock;                    ///< Maps scene time to the field's time.
    WindAdjustment adjustment;          ///< Scales and turns velocities.
    WindFrame frame = WindFrame::Scene; ///< The frame of the field and of the sources.
    /// The effect of the trees on the wind. Unset: as in the forest's previous wind; if that had none either,
    /// trees do not change the wind.
    std::optional<WindCanopy> canopy;
    std::vector<WindSource> sources; ///< Local sources, such as rotors, above and among the trees.

    Wind() = default; ///< Calm.
    /// A field without modifications.
    template <typename Field, typename = std::enable_if_t<std::is_convertible_v<Field*, const WindField*>>>
    Wind(std::shared_ptr<Field> given, WindFrame axes = WindFrame::Scene)
        : field(std::move(given)), frame(axes) {}
    Wind(std::nullptr_t) {} ///< Calm.

    bool isCalm() const { return !field && sources.empty(); } ///< No field and no sources.

private:
    friend struct WindInternals;
    WindFieldPtr _fieldFromFiles; ///< The field that `_files` and `_map` belong to.
    std::shared_ptr<const WindFiles> _files;
    std::shared_ptr<const WindMap> _map;
};

/// A wind without the effect of its canopy as a single field, for a forest at the scene's zero; null if calm.
OSGTREEWIND_EXPORT WindFieldPtr asField(const Wind& wind);

/// The problems of a wind's frame and canopy; empty if valid. Adjustments and sources are only clamped.
[[nodiscard]] OSGTREEWIND_EXPORT Diagnostics check(const Wind& wind);

} // namespace osgTreeWind
