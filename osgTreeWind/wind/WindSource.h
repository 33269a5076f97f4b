// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// A local source of wind (Wind::sources), such as a rotor or a vehicle, in metres, seconds and the frame of
/// the wind. A shelter reduces the wind, all other kinds add to it. A source ends where it adds less than 0.2
/// m/s (the upper limit of Beaufort 0) and fades over the last fifth of that distance. Members that a kind
/// does not use have no effect; values out of range are clamped.
struct WindSource {
    /// The kind of source and its model.
    enum class Kind {
        /// A hovering helicopter: its downwash and the outwash along the ground. The column below the disk
        /// follows momentum theory (Leishman 2006, 2.2: twice the induced velocity far below, momentum equal
        /// to the thrust), the outwash is a radial wall jet (Poreh, Tsuei and Cermak 1967; profile: Verhoff
        /// 1963). A crosswind reduces the induced velocity (Glauert; Leishman 2006, 2.14) and deflects the
        /// sinking column; the outwash spreads evenly from where the column meets the ground, which is valid
        /// for winds slower than the induced velocity.
        Rotor,
        /// A fan or blower: a round turbulent jet (Pope 2000, 5.1: B = 5.8, S = 0.094).
        Jet,
        /// A vertical Lamb-Oseen vortex: a dust devil, a wing-tip vortex.
        Vortex,
        /// A place sheltered by walls or screens, where only a share of the wind remains.
        Shelter,
        /// A lorry or train. Its wake conserves its moment about the ground, decays as distance^-3/4 and
        /// widens as distance^1/4, as in theory and wind tunnels (Eskridge and Hunt 1979; Eskridge and
        /// Thompson 1982, from 10 heights on), with the eddy viscosity of wakes (Tennekes and Lumley 1972,
        /// 4.2). The flow around the body is that of a source at the front and a sink at the rear
        /// (Sanz-Andres et al. 2003). The wake points along the air relative to the vehicle, wind included.
        Vehicle,
        /// An explosion on the ground: the blast wind behind the front, which decays and reverses (Kinney and
        /// Graham 1985). Modelled as an equivalent drag wind: the steady wind with the mean drag of the last
        /// 0.2 s, up to 200 m/s, so that trees feel the impulse of the blast but not its peak. It does not
        /// move, is not deflected by the wind and has no turbulence.
        Explosion,
    };
    Kind kind = Kind::Rotor; ///< Which of these it is.
    /// Position at scene time 0: hub of a rotor, mouth of a jet, foot of a vortex or shelter, ground below
    /// the middle of a vehicle's rear, charge of an explosion.
    glm::dvec3 position{0.0};
    glm::dvec3 velocity{0.0}; ///< Of the source, m/s, [-1000, 1000]; horizontal for a vehicle.
    /// Radius of a rotor, jet mouth or shelter, radius of maximum speed of a vortex, half the width of a
    /// vehicle. (0, 1000]
    double radius = 5.0;
    double thrust = 30000.0; ///< Thrust of a rotor, N: the weight of the helicopter. [0, 1e7]
    double speed = 10.0;     ///< At the mouth of a jet; maximum of a vortex, negative: clockwise. [-200, 200]
    float toward = 0.0f;     ///< Direction of a jet, radians clockwise from north; at most a full turn.
    float elevation = 0.0f;  ///< Angle of a jet above the horizontal, radians. [-pi/2, pi/2]
    double height = 10.0;    ///< Height of a vortex, shelter or vehicle. (0, 10000]
    double length = 16.0;    ///< Length of a vehicle. (0, 1000]
    double dragArea = 6.0;   ///< Drag area Cd A of a vehicle, m^2: 6 for a lorry, 0.7 for a car. [0, 1000]
    double share = 0.2;      ///< Share of the wind that remains in a shelter. [0, 1]
    double charge = 10.0;    ///< Charge of an explosion, kg of TNT. (0, 1e9]
    double time = 0.0;       ///< Scene time of an explosion, seconds. [-1e9, 1e9]
    /// Turbulence: standard deviation of each added component over the local added speed, [0, 1]. It is 0.25
    /// on the axis of a round jet (Hussein, Capp and George 1994) and about as much in wall jets.
    double turbulence = 0.25;
};

} // namespace osgTreeWind
