// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/CanopyMap.h>
#include <osgTreeWind/wind/GustNoise.h>
#include <osgTreeWind/wind/HorizontalWind.h>
#include <osgTreeWind/wind/PlaceInStand.h>
#include <osgTreeWind/wind/SlowGusts.h>
#include <osgTreeWind/wind/WindLayer.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace osgTreeWind {

/// Extends a wind that ignores the trees down into the canopy.
///
/// The mean wind at the map's reference height is scaled downward by the profile of the stand upwind.
/// Turbulence inside the canopy is synthetic: eddies about as long as trees are high, advected at 1.8 times
/// the mean wind at the tree tops (Raupach, Finnigan and Brunet 1996), which change on their way, with rare
/// and strong sweeps from above that vary in direction. A wind with synthetic gusts of its own also varies
/// over minutes. Toward open country the flow blends into the open wind with its own gusts. The result
/// depends only on place and time, and is finite for finite arguments.
class CanopyFlow final : public WindLayer {
public:
    /// @param open the wind above the canopy, not null. @param mean the same without synthetic gusts.
    /// @param map not null, after CanopyMap::setReference().
    CanopyFlow(WindFieldPtr open, WindFieldPtr mean, std::shared_ptr<const CanopyMap> map,
               std::uint32_t seed);

    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;

    /// Crown contact and shelter of a tree at this place, in the mean wind.
    NeighbourEffect neighbourEffectAt(const glm::vec2& place) const;
    /// Horizontal mean wind of one hour at the reference height, m/s.
    const glm::vec3& meanWind() const { return _meanWind; }

private:
    float topSpeedOf(const HorizontalWind& wind) const;
    CanopySample standUpwindOf(const glm::vec3& place, const HorizontalWind& wind) const;
    PlaceInStand placeInStand(const WindPlace& place, const HorizontalWind& wind) const;
    PlaceInStand keptPlaceInStand(const WindPlace& place, const HorizontalWind& wind) const;

    WindFieldPtr _open, _mean;
    std::shared_ptr<const CanopyMap> _map;
    glm::vec3 _meanWind;
    glm::vec3 _gustVelocity; ///< Velocity that advects the gusts, m/s.
    GustNoise _noise;
    SlowGusts _slowGusts;
    std::uint64_t _number; ///< Of this object, to tell its PlaceInStand from those of others.
    float _slowIntensity;  ///< Standard deviation of slow gusts over the mean speed.
};

} // namespace osgTreeWind
