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

/// Whose axes a wind is given in: its places, its velocities and what is up (docs/coordinates.md).
enum class WindFrame {
    Forest,    ///< The forest's own, metres from its origin: it stays with the forest wherever that is put.
    Scene,     ///< Those of the scene's root, z up; or of the world less the forest's origin, where the
               ///< forest stands nearer to its origin than to the scene's zero.
    Geocentric ///< Those of the scene's root, which is a globe: up is the forest's own z.
};

/// A wind, as a value: a field, and what is done to it, in the order of the members.
///
///     Wind wind(std::make_shared<UniformWind>(glm::vec3(6, 0, 0)));
///     wind.adjustment.turn = 20.0;
///     wind.sources.push_back(helicopter);
///     forest->setWind(wind);
struct OSGTREEWIND_EXPORT Wind {
    WindFieldPtr field;                 ///< Null: calm.
    WindClock clock;                    ///< The field's time.
    WindAdjustment adjustment;          ///< Stronger, weaker, turned.
    WindFrame frame = WindFrame::Scene; ///< Whose axes all of it is given in.
    /// How it goes on among the trees. Unset: as the forest's wind before; if that had none either, trees do
    /// not change the wind.
    std::optional<WindCanopy> canopy;
    std::vector<WindSource> sources; ///< What moves the air in addition, above the trees and among them.

    Wind() = default; ///< A calm.
    /// A field as it is.
    template <typename Field, typename = std::enable_if_t<std::is_convertible_v<Field*, const WindField*>>>
    Wind(std::shared_ptr<Field> given, WindFrame axes = WindFrame::Scene)
        : field(std::move(given)), frame(axes) {}
    Wind(std::nullptr_t) {} ///< A calm.

    bool isCalm() const { return !field && sources.empty(); } ///< Whether nothing moves the air.

private:
    friend struct WindParts;
    WindFieldPtr _read; ///< The field that was read from files; another `field` has neither of these.
    std::shared_ptr<const WindFiles> _files;
    std::shared_ptr<const WindMap> _map;
};

/// All of a wind but its canopy as one field, where a forest that stands at the scene's zero meets it; null:
/// a calm.
OSGTREEWIND_EXPORT WindFieldPtr asField(const Wind& wind);

/// The problems of a wind's frame and of its canopy's numbers; empty: none. Adjustments and sources are
/// clamped.
OSGTREEWIND_EXPORT Diagnostics check(const Wind& wind);

} // namespace osgTreeWind
