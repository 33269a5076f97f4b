// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/CanopyFlow.h>
#include <osgTreeWind/wind/SourceGrid.h>
#include <osgTreeWind/wind/Wind.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <memory>

namespace osgTreeWind {

/// A Wind as a forest meets it: takes blocks of places, in the forest's axes, through all that is done to the
/// wind. The forest's own motion makes no wind.
class WindSampler final : public WindField {
public:
    /// @param wind not null. @param forestToScene where the forest stands. @param canopy the stands among
    /// which it goes on, referred (CanopyMap::refer()); null: it is taken as it is.
    explicit WindSampler(std::shared_ptr<const Wind> wind, const glm::dmat4& forestToScene = glm::dmat4(1.0),
                         std::shared_ptr<const CanopyMap> canopy = nullptr);

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;

    /// The wind among the trees; null where trees do not change it.
    const std::shared_ptr<const CanopyFlow>& canopy() const { return _canopy; }

private:
    class AboveCanopy;
    WindPlace toWindFrame(const WindPlace& place) const;
    void sampleData(const WindField& field, const WindPlace* places, std::size_t count, double time,
                    glm::vec3* out) const;
    void sampleOpen(const WindField& field, const WindPlace* places, std::size_t count, double time,
                    glm::vec3* out) const;
    glm::vec3 airAt(const WindPlace& place, double time) const;
    void addSources(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const;

    std::shared_ptr<const Wind> _wind;
    WindFieldPtr _mean; ///< Its field without made-up gusts.
    glm::mat3 _adjust{1.0f};
    bool _isAdjusted, _isInAnotherFrame;
    glm::dmat4 _toWind;        ///< Takes places of the forest to the wind's axes,
    glm::dmat3 _turnBack;      ///< and velocities back.
    double _heightScale = 1.0; ///< From heights in the forest's axes to those in the wind's.
    std::shared_ptr<const CanopyFlow> _canopy;
    SourceGrid _sources;
};

/// All of a wind but its canopy as one field in the forest's axes: null for a calm, and the wind's own field
/// where nothing is done to it. @param wind not null.
WindFieldPtr asField(std::shared_ptr<const Wind> wind, const glm::dmat4& forestToScene);

} // namespace osgTreeWind
