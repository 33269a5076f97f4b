// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

#include <glm/vec3.hpp>

#include <vector>

namespace osgTreeWind {

/// The thesis' forestWind array (§4.2) in its own axes and with its own indexing; the same wind at all
/// heights and times. Made by GridWind::fromForestWind, which checks the array.
class ForestWind final : public WindField {
public:
    /// @param width, length at least 1.
    /// @param values width * length * 3 finite components in thesis axes.
    /// @param origin scene position of the array's corner, thesis (0, 0, 0).
    ForestWind(int width, int length, std::vector<float> values, const glm::dvec3& origin);

    glm::vec3 velocity(const WindPlace& place, double time) const override;

    int width() const { return _width; }
    int length() const { return _length; }
    const std::vector<float>& values() const { return _values; }
    const glm::dvec3& origin() const { return _origin; }

private:
    int _width;
    int _length;
    std::vector<float> _values;
    glm::dvec3 _origin;
};

} // namespace osgTreeWind
