// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// The air that an explosion on the ground moves. The front is that of TNT (Kinney and Graham 1985, Explosive
/// Shocks in Air: overpressure and duration by scaled distance), of 1.8 times the charge, as the ground
/// throws back what would have gone down; the air behind it has the speed that shock relations give (Rankine
/// and Hugoniot) and dies down, and flows back, as Friedlander has it: (1 - s) exp(-s) after s durations
/// (Glasstone and Dolan 1977, 3.57).
class BlastWave {
public:
    /// @param charge kg of TNT, above 0.
    explicit BlastWave(double charge);

    /// As the front comes by.
    struct Front {
        double overpressure = 0.0; ///< Pa.
        double wind = 0.0;         ///< Behind it, away from the charge, m/s.
        double arrival = 0.0;      ///< Seconds after it goes off.
        double duration = 0.0;     ///< Seconds until the air turns back.
    };
    /// @param distance from the charge, metres.
    Front front(double distance) const;
    /// How far it goes until wind() is nowhere above `wind`, m/s above 0; metres.
    double reach(double wind) const;

    /// Away from the charge, m/s, within 200: the wind whose drag is the mean drag of the last 0.2 s. A blast
    /// is over in some 0.02 s, and forests ask for the wind every 0.1 s at times; so they feel all of its
    /// push whenever they ask. @param time seconds since it goes off.
    double wind(double distance, double time) const;

private:
    double _scale; ///< Metres and seconds over those of a kilogram in free air.
};

} // namespace osgTreeWind
