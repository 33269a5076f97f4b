// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// Something that moves the air in a place (Wind::sources). Metres, seconds, the axes that the wind is given
/// in. A shelter takes its share of the wind, all others add to it. A source reaches as far as it adds 0.2
/// m/s (Beaufort 0 ends there), and fades over the last fifth of that. Members that a kind does not use have
/// no effect; values out of range are clamped.
struct WindSource {
    /// What moves it, and by which model.
    enum class Kind {
        /// A hovering helicopter, and its wash along the ground. The column below the disk is that of
        /// momentum theory (Leishman 2006, 2.2: twice the induced velocity far below, momentum equal to the
        /// thrust); what it makes of the ground is a radial wall jet (Poreh, Tsuei and Cermak 1967; profile:
        /// Verhoff 1963). Air that goes past it takes from the induced velocity (Glauert; Leishman
        /// 2006, 2.14)
        /// and carries the column off as it sinks; from where it meets the ground the wash goes out evenly,
        /// which holds for winds below that velocity.
        Rotor,
        /// A fan, a blower: a round turbulent jet (Pope 2000, 5.1: B = 5.8, S = 0.094).
        Jet,
        /// A whirl about the vertical, as Lamb and Oseen's: a dust devil, what a wing tip leaves.
        Vortex,
        /// Less wind between walls, behind screens: a share of it is left.
        Shelter,
        /// A lorry, a train. Behind it the air follows: a wake that keeps its moment about the ground,
        /// decays as distance^-3/4 and widens as distance^1/4, as theory and wind tunnel have it (Eskridge
        /// and Hunt 1979; Eskridge and Thompson 1982, from 10 heights behind on); its eddy viscosity is that
        /// of wakes (Tennekes and Lumley 1972, 4.2). Around it the flow about a body of its section (a
        /// source before it and a sink behind, as Sanz-Andres et al. 2003 for what stands beside a road). The
        /// wake lies along the air as the vehicle meets it, wind included.
        Vehicle,
        /// An explosion on the ground: the air behind its front, which dies down and flows back (Kinney and
        /// Graham 1985). It comes as the wind whose drag is the mean drag of the last 0.2 s, up to 200 m/s:
        /// the push that a tree feels is that of the blast, its peak is not. It stands still, and is as it
        /// is:
        /// no wind carries it off, it knows no turbulence.
        Explosion,
    };
    Kind kind = Kind::Rotor;  ///< Of these.
    glm::dvec3 position{0.0}; ///< At time 0: a rotor's hub, a jet's mouth, the foot of a vortex or a
                              ///< shelter, the ground below the middle of a vehicle's rear, a charge.
    glm::dvec3 velocity{0.0}; ///< It moves with, m/s, each within [-1000, 1000]; a vehicle on the level.
    double radius = 5.0;      ///< Of a rotor, a mouth or a shelter; where a vortex is fastest; half of a
                              ///< vehicle's width. (0, 1000]
    double thrust = 30000.0;  ///< Of a rotor, N: the weight that hovers. [0, 1e7]
    double speed = 10.0;      ///< At a jet's mouth; the fastest of a vortex, negative: clockwise. [-200, 200]
    double toward = 0.0;      ///< Where a jet blows: degrees clockwise from north, [-360, 360], and
    double elevation = 0.0;   ///< upward, [-90, 90].
    double height = 10.0;     ///< Up to which a vortex or a shelter reaches; of a vehicle. (0, 10000]
    double length = 16.0;     ///< Of a vehicle. (0, 1000]
    double dragArea = 6.0;    ///< Of a vehicle: Cd A, m^2; 6 of a lorry, 0.7 of a car. [0, 1000]
    double share = 0.2;       ///< Of the wind that a shelter leaves. [0, 1]
    double charge = 10.0;     ///< Of an explosion: kg of TNT. (0, 1e9]
    double time = 0.0;        ///< At which it goes off: seconds of the wind's time. [-1e9, 1e9]
    /// Of what it adds: standard deviation of each component over the speed there, [0, 1]. On the axis of a
    /// round jet it is a quarter (Hussein, Capp and George 1994), in wall jets as much.
    double turbulence = 0.25;
};

} // namespace osgTreeWind
