// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/CanopyFlow.h>
#include <osgTreeWind/wind/Wind.h>

#include <glm/mat4x4.hpp>

#include <memory>

namespace osgTreeWind {

/// A Wind at places in the forest's frame. Layers of fields lie on top of each other, and each samples the
/// one below it: the data with clock, map and adjustment; the frame; the canopy; the sources. Motion of the
/// forest node does not add to the wind.
class LayeredWind final : public WindField {
public:
    /// @param wind not null. @param forestToScene transform of the forest.
    /// @param canopy the stands, after CanopyMap::setReference(); null: trees do not change the wind.
    /// @param seed of the turbulence among the trees.
    explicit LayeredWind(std::shared_ptr<const Wind> wind, const glm::dmat4& forestToScene = glm::dmat4(1.0),
                         std::shared_ptr<const CanopyMap> canopy = nullptr, std::uint32_t seed = 1);

    glm::vec3 velocity(const WindPlace& place, double time) const override {
        return _top ? _top->velocity(place, time) : glm::vec3(0.0f);
    }
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;

    /// The uppermost layer: the wind's own field if nothing modifies it; null if calm.
    const WindFieldPtr& top() const { return _top; }
    /// The wind among the trees; null if trees do not change the wind.
    const std::shared_ptr<const CanopyFlow>& canopy() const { return _canopy; }

private:
    WindFieldPtr _top;
    std::shared_ptr<const CanopyFlow> _canopy;
};

} // namespace osgTreeWind
