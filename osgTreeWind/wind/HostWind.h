// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/Wind.h>

#include <glm/mat4x4.hpp>

#include <memory>
#include <mutex>

namespace osgTreeWind {

/// The wind that the host sets for a forest, and the transform of the forest. Any thread may set and get the
/// wind at any time.
class HostWind {
public:
    explicit HostWind(Wind given = {});

    /// Replaces the wind. A wind without a canopy keeps the canopy of the previous wind.
    /// @return what check() finds; then nothing has changed.
    Diagnostics set(Wind given);
    std::shared_ptr<const Wind> get() const; ///< Never null.

    /// The transform from the forest's coordinates to the scene. One thread only.
    void setForestToScene(const glm::dmat4& forestToScene) { _forestToScene = forestToScene; }
    const glm::dmat4& forestToScene() const { return _forestToScene; }
    /// The wind in the forest's coordinates, not changed by the trees; null if calm. Returns the same object
    /// until the wind or the transform changes. One thread only.
    WindFieldPtr fieldWithoutTrees();

private:
    mutable std::mutex _mutex; // guards _wind
    std::shared_ptr<const Wind> _wind;
    glm::dmat4 _forestToScene{1.0};
    std::shared_ptr<const Wind> _cachedWind; ///< Wind and transform that `_cachedField` was built from.
    glm::dmat4 _cachedForestToScene{1.0};
    WindFieldPtr _cachedField;
};

} // namespace osgTreeWind
