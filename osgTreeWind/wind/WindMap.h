// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsMesh.h>
#include <osgTreeWind/wind/WindField.h>

#include <memory>

namespace osgTreeWind {

/// A wind on a map of its own, or on degrees, as it is met on another map: places are brought there,
/// velocities turned from its y axis to that of here.
class MappedWind final : public WindField {
public:
    /// @param wind not null. @param mesh from here to its map, not null.
    /// @param origin the place here that is (0, 0) of this wind. @param itsOrigin the same of `wind`, on its
    /// map.
    MappedWind(WindFieldPtr wind, std::shared_ptr<const CrsMesh> mesh, const glm::dvec2& origin,
               const glm::dvec2& itsOrigin);

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;

private:
    WindPlace there(const WindPlace& place) const;
    glm::vec3 turned(const WindPlace& place, const glm::vec3& velocity) const;

    WindFieldPtr _wind;
    std::shared_ptr<const CrsMesh> _mesh;
    glm::dvec2 _origin, _itsOrigin;
};

} // namespace osgTreeWind
