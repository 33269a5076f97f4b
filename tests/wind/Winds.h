// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/LayeredWind.h>

#include <memory>
#include <utility>
#include <vector>

/// Samplers of a field with a single modification.
namespace osgTreeWind {

inline LayeredWind sampler(Wind wind, const glm::dmat4& place = glm::dmat4(1.0),
                           std::shared_ptr<const CanopyMap> canopy = nullptr) {
    return LayeredWind(std::make_shared<const Wind>(std::move(wind)), place, std::move(canopy));
}

inline Wind windWithSources(WindFieldPtr field, std::vector<WindSource> sources) {
    Wind wind(std::move(field));
    wind.sources = std::move(sources);
    return wind;
}

inline LayeredWind withSources(WindFieldPtr field, std::vector<WindSource> sources) {
    return sampler(windWithSources(std::move(field), std::move(sources)));
}

inline LayeredWind withClock(WindFieldPtr field, const WindClock& clock) {
    Wind wind(std::move(field));
    wind.clock = clock;
    return sampler(std::move(wind));
}

inline LayeredWind withAdjustment(WindFieldPtr field, const WindAdjustment& adjustment) {
    Wind wind(std::move(field));
    wind.adjustment = adjustment;
    return sampler(std::move(wind));
}

inline LayeredWind inStand(Wind wind, const CanopyMap& stand, float reference, std::uint32_t seed) {
    auto map = std::make_shared<CanopyMap>(stand);
    map->setReference(reference);
    return LayeredWind(std::make_shared<const Wind>(std::move(wind)), glm::dmat4(1.0), map, seed);
}

} // namespace osgTreeWind
