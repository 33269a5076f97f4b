// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/wind/WindField.h>

#include <glm/vec3.hpp>

#include <utility>
#include <vector>

namespace osgTreeWind {

/// The thesis' forestWind array (§4.2) in its own axes and with its own indexing; the same wind at all
/// heights and times. Made by GridWind::fromForestWind, which checks the array.
///
///     if (const auto wind = GridWind::fromForestWind(1, 1, {4.0f, 0.0f, 0.0f}))
///         forest->setWind(wind.value());
class OSGTREEWIND_EXPORT ForestWind final : public WindField {
public:
    /// The array, with its size and its place.
    struct Array {
        int width = 1;             ///< Cells of 1 m along thesis x.
        int length = 1;            ///< Cells of 1 m along thesis z.
        std::vector<float> values; ///< width * length * 3 finite components in thesis axes.
        glm::dvec3 origin{0.0};    ///< Scene position of the array's corner, thesis (0, 0, 0).
    };
    /// @param array as GridWind::fromForestWind has checked it.
    explicit ForestWind(Array array) : _array(std::move(array)) {}

    const Array& array() const { return _array; } ///< As given.

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    KindOfWind kind() const override { return this; }

private:
    Array _array;
};

} // namespace osgTreeWind
