// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// The blast wind of an explosion on the ground.
///
/// Overpressure and duration by scaled distance are those of TNT (Kinney and Graham 1985, Explosive Shocks in
/// Air) of 1.8 times the charge, because the ground reflects the downward half. The wind behind the front
/// follows from the Rankine-Hugoniot relations, then decays and reverses as a Friedlander wave:
/// (1 - s) exp(-s) after s durations (Glasstone and Dolan 1977, 3.57).
class BlastWave {
public:
    /// @param charge kg of TNT, above 0.
    explicit BlastWave(double charge);

    /// The state of the air as the front passes.
    struct Front {
        double overpressure = 0.0; ///< Pa.
        double wind = 0.0;         ///< Behind the front, away from the charge, m/s.
        double arrival = 0.0;      ///< Seconds after the explosion.
        double duration = 0.0;     ///< Seconds until the wind reverses.
    };
    /// @param distance from the charge, metres.
    Front front(double distance) const;
    /// Distance in metres beyond which wind() never exceeds `wind`. @param wind m/s, above 0.
    double reach(double wind) const;

    /// Wind away from the charge, m/s, clamped to [-200, 200]: the steady wind with the mean drag of the last
    /// 0.2 s. A blast lasts about 0.02 s, and a forest may sample the wind only every 0.1 s; the average
    /// gives trees the full impulse at any sampling rate. @param time seconds since the explosion.
    double wind(double distance, double time) const;

private:
    double _scale; ///< Ratio of lengths and times to those of 1 kg in free air.
};

} // namespace osgTreeWind
