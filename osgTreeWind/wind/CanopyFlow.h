// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/CanopyMap.h>
#include <osgTreeWind/wind/GustNoise.h>
#include <osgTreeWind/wind/WindField.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace osgTreeWind {

/// A wind that does not know of the trees, continued down among them.
///
/// At the map's reference above the ground it is the mean of the canopy's wind, which is scaled from there as
/// the stand's profile says. Turbulence is the canopy's own: about as long as trees are high, carried along
/// at 1.8 times the mean at their tops (Raupach, Finnigan and Brunet 1996), with sweeps, rare and strong,
/// that come from above and swing in direction. Toward open country the given wind takes over with its own
/// gusts. A function of place and time, finite for finite arguments.
class CanopyFlow {
public:
    /// @param mean the wind above, without the gusts that it makes up. @param map not null; refer() was
    /// called.
    CanopyFlow(const WindField& mean, std::shared_ptr<const CanopyMap> map, std::uint32_t seed);

    /// WindField::sample(). @param open the wind above. @param mean the same without gusts.
    void sample(const WindField& open, const WindField& mean, const WindPlace* places, std::size_t count,
                double time, glm::vec3* out) const;

    /// The neighbours and the shelter of a tree there, in the mean wind.
    TreeCompany companyAt(const glm::vec2& place) const;
    /// Mean of an hour at the reference, level, m/s.
    const glm::vec3& meanWind() const { return _usual; }

private:
    struct LevelWind;
    CanopyAt standOf(const glm::vec3& place, const LevelWind& wind) const;
    glm::vec3 among(const CanopyAt& stand, const WindPlace& place, const LevelWind& given,
                    const NoisePoint& noise) const;

    std::shared_ptr<const CanopyMap> _map;
    glm::vec3 _usual;        ///< Mean wind at the reference.
    glm::vec3 _gustVelocity; ///< At which gusts travel, m/s.
    GustNoise _noise;
};

} // namespace osgTreeWind
