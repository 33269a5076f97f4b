// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Whose axes a wind is given in: its places, its velocities and what is up (docs/coordinates.md).
enum class WindFrame {
    Forest,    ///< The forest's own, metres from its origin: it stays with the forest wherever that is put.
    Scene,     ///< Those of the scene's root, z up; or of the world less the forest's origin, where the
               ///< forest stands nearer to its origin than to the scene's zero.
    Geocentric ///< Those of the scene's root, which is a globe: up is the forest's own z.
};

} // namespace osgTreeWind
