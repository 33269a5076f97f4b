// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/wind/WindField.h>

#include <glm/vec3.hpp>

#include <utility>
#include <vector>

namespace osgTreeWind {

/// Wind from the forestWind array of the thesis (§4.2), in the axes and indexing of the thesis; the same at
/// all heights and times. Create it with GridWind::fromForestWind(), which checks the array.
///
///     if (const auto wind = GridWind::fromForestWind(1, 1, {4.0f, 0.0f, 0.0f}))
///         report(forest->setWind(wind.value()));
class OSGTREEWIND_EXPORT ThesisWind final : public WindField {
public:
    /// The array with its size and position.
    struct Array {
        int width = 1;             ///< Cells of 1 m along thesis x.
        int length = 1;            ///< Cells of 1 m along thesis z.
        std::vector<float> values; ///< width * length * 3 finite components in thesis axes.
        glm::dvec3 origin{0.0};    ///< Scene position of the array's corner, thesis (0, 0, 0).
    };
    /// @param array checked by GridWind::fromForestWind().
    explicit ThesisWind(Array array) : _array(std::move(array)) {}

    const Array& array() const { return _array; } ///< The array as given.

    glm::vec3 velocity(const WindPlace& place, double time) const override;

private:
    Array _array;
};

} // namespace osgTreeWind
