// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/SourcesByHand.h>

namespace osgTreeWind {

std::vector<WindSource> sourcesByHand(const glm::dvec3& foot, double height, double time) {
    WindSource helicopter; // a Super Puma's rotor
    helicopter.position = foot + glm::dvec3(0.0, 0.0, height + 15.0);
    helicopter.radius = 7.8;
    helicopter.thrust = 70000.0;
    WindSource fan;
    fan.kind = WindSource::Kind::Jet;
    fan.position = foot + glm::dvec3(-height, 0.0, 0.6 * height);
    fan.toward = 90.0;
    fan.radius = 2.0;
    fan.speed = 30.0;
    WindSource whirl;
    whirl.kind = WindSource::Kind::Vortex;
    whirl.position = foot + glm::dvec3(5.0, 0.0, 0.0);
    whirl.radius = 4.0;
    whirl.speed = 15.0;
    whirl.height = 2.0 * height;
    WindSource shelter;
    shelter.kind = WindSource::Kind::Shelter;
    shelter.position = foot;
    shelter.radius = 10.0;
    shelter.height = 1.2 * height;
    shelter.share = 0.1;
    WindSource explosion;
    explosion.kind = WindSource::Kind::Explosion;
    explosion.position = foot + glm::dvec3(-15.0, 0.0, 0.0);
    explosion.charge = 100.0;
    explosion.time = time + 1.0;
    return {helicopter, fan, whirl, shelter, explosion};
}

} // namespace osgTreeWind
