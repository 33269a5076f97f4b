// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/Wind.h>

#include <glm/mat4x4.hpp>

#include <memory>
#include <mutex>

namespace osgTreeWind {

/// The wind that a forest is given, and where the forest stands in it: any thread may set and get the wind at
/// any time.
class GivenWind {
public:
    explicit GivenWind(Wind given = {});

    /// One without a canopy keeps that of the wind before.
    void set(Wind given);
    std::shared_ptr<const Wind> get() const; ///< Never null.

    /// Where the forest stands: takes its places to the scene. One thread.
    void setPlace(const glm::dmat4& forestToScene) { _place = forestToScene; }
    const glm::dmat4& place() const { return _place; } ///< As set.
    /// The wind in the forest's own coordinates as if no tree were there; null: calm. The same object while
    /// nothing changes. One thread.
    WindFieldPtr here();

private:
    mutable std::mutex _mutex; // guards _given
    std::shared_ptr<const Wind> _given;
    glm::dmat4 _place{1.0};
    std::shared_ptr<const Wind> _metGiven; ///< What here() was made of,
    glm::dmat4 _metPlace{1.0};
    WindFieldPtr _met; ///< and it.
};

} // namespace osgTreeWind
