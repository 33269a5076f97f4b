// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

#include <glm/mat4x4.hpp>

#include <mutex>
#include <utility>

namespace osgTreeWind {

/// A wind, and whose axes it is given in.
struct FramedWind {
    WindFieldPtr wind; ///< Null: calm.
    WindFrame frame = WindFrame::Scene;
    bool operator==(const FramedWind& other) const { return wind == other.wind && frame == other.frame; }
};

/// The wind that a forest is given: any thread may set and get it at any time. Whoever moves the forest meets
/// it where the forest stands.
class GivenWind {
public:
    explicit GivenWind(FramedWind given = {}) : _given(std::move(given)) {}

    void set(FramedWind given);
    FramedWind get() const;

    /// Where the forest stands: takes its places to the scene. One thread.
    void setPlace(const glm::dmat4& forestToScene) { _place = forestToScene; }
    /// In the forest's own coordinates; the same object while nothing changes. One thread.
    WindFieldPtr here();

private:
    mutable std::mutex _mutex; // guards _given
    FramedWind _given;
    glm::dmat4 _place{1.0};
    FramedWind _metGiven; ///< What here() was made of,
    glm::dmat4 _metPlace{1.0};
    WindFieldPtr _met; ///< and it.
};

} // namespace osgTreeWind
