// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

#include <glm/mat4x4.hpp>

#include <mutex>
#include <utility>

namespace osgTreeWind {

/// The wind that a forest is given: any thread may set and get it at any time. Whoever moves the forest meets
/// it where the forest stands.
class GivenWind {
public:
    /// @param wind null: calm.
    explicit GivenWind(WindFieldPtr wind = {}) : _wind(std::move(wind)) {}

    void set(WindFieldPtr wind);
    WindFieldPtr get() const;

    /// Where the forest stands: takes its places to those of the wind. One thread.
    void setPlace(const glm::dmat4& forestToWind) { _place = forestToWind; }
    /// In the forest's own coordinates; the same object while nothing changes. One thread.
    WindFieldPtr here();

private:
    mutable std::mutex _mutex; // guards _wind
    WindFieldPtr _wind;
    glm::dmat4 _place{1.0};
    WindFieldPtr _metWind, _met; ///< What here() was made of, at `_metPlace`, and it.
    glm::dmat4 _metPlace{1.0};
};

} // namespace osgTreeWind
