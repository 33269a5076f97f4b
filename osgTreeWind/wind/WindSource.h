// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// Air that something moves in a place, beside the wind there (WindWithSources). Metres, seconds, the axes
/// that the wind is given in. Members that a kind has no use for do not count.
struct WindSource {
    enum class Kind {
        /// A hovering helicopter, and its wash along the ground. The column below the disk is that of
        /// momentum
        /// theory (Leishman 2006, 2.2: twice the induced velocity far below, momentum equal to the thrust);
        /// what it makes of the ground is a radial wall jet (Poreh, Tsuei and Cermak 1967; profile: Verhoff
        /// 1963). No wind bends it.
        Rotor,
        /// A fan, a blower: a round turbulent jet (Pope 2000, 5.1: B = 5.8, S = 0.094).
        Jet,
        /// A whirl about the vertical, as Lamb and Oseen's: a dust devil, what a wing tip leaves.
        Vortex,
        /// Less wind between walls, behind screens: a share of it is left.
        Shelter,
    };
    Kind kind = Kind::Rotor;
    glm::dvec3 position{0.0}; ///< At time 0: a rotor's hub, a jet's mouth, the foot of a vortex or a shelter.
    glm::dvec3 velocity{0.0}; ///< It moves with, m/s, each within [-1000, 1000].
    double radius = 5.0;      ///< Of a rotor, a mouth or a shelter; where a vortex is fastest. (0, 1000]
    double thrust = 30000.0;  ///< Of a rotor, N: the weight that hovers. [0, 1e7]
    double speed = 10.0;      ///< At a jet's mouth; the fastest of a vortex, negative: clockwise. [-200, 200]
    double toward = 0.0;      ///< Where a jet blows: degrees clockwise from north, [-360, 360], and
    double elevation = 0.0;   ///< upward, [-90, 90].
    double height = 10.0;     ///< Up to which a vortex or a shelter reaches. (0, 10000]
    double share = 0.2;       ///< Of the wind that a shelter leaves. [0, 1]
    /// Of what it adds: standard deviation of each component over the speed there, [0, 1]. On the axis of a
    /// round jet it is a quarter (Hussein, Capp and George 1994), in wall jets as much.
    double turbulence = 0.25;
};

} // namespace osgTreeWind
