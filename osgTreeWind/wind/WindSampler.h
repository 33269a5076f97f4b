// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/CanopyFlow.h>
#include <osgTreeWind/wind/SourceGrid.h>
#include <osgTreeWind/wind/Wind.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <memory>

namespace osgTreeWind {

/// Samples a Wind at places in the forest's frame with all of its modifications: clock, WindMap, adjustment,
/// frame, canopy and sources. Motion of the forest node does not add to the wind.
class WindSampler final : public WindField {
public:
    /// @param wind not null. @param forestToScene transform of the forest.
    /// @param canopy the stands, after CanopyMap::setReference(); null: trees do not change the wind.
    explicit WindSampler(std::shared_ptr<const Wind> wind, const glm::dmat4& forestToScene = glm::dmat4(1.0),
                         std::shared_ptr<const CanopyMap> canopy = nullptr);

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;

    /// The wind among the trees; null if trees do not change the wind.
    const std::shared_ptr<const CanopyFlow>& canopy() const { return _canopy; }

private:
    class AboveCanopy;
    WindPlace toWindFrame(const WindPlace& place) const;
    void sampleData(const WindField& field, const WindPlace* places, std::size_t count, double time,
                    glm::vec3* out) const;
    void sampleOpen(const WindField& field, const WindPlace* places, std::size_t count, double time,
                    glm::vec3* out) const;
    glm::vec3 ambientWindAt(const WindPlace& place, double time) const;
    void addSources(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const;

    std::shared_ptr<const Wind> _wind;
    WindFieldPtr _mean; ///< The field without synthetic gusts.
    glm::mat3 _adjust{1.0f};
    bool _isAdjusted, _isInAnotherFrame;
    glm::dmat4 _toWind;        ///< Transforms places from the forest's frame to the wind's.
    glm::dmat3 _turnBack;      ///< Turns velocities from the wind's frame to the forest's.
    double _heightScale = 1.0; ///< Scales heights from the forest's frame to the wind's.
    std::shared_ptr<const CanopyFlow> _canopy;
    SourceGrid _sources;
};

/// A wind without the effect of its canopy as a single field in the forest's frame: null if calm, the wind's
/// own field if nothing modifies it. @param wind not null.
WindFieldPtr asField(std::shared_ptr<const Wind> wind, const glm::dmat4& forestToScene);

} // namespace osgTreeWind
