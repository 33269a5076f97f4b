// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

namespace osgTreeWind {

/// Another wind at its own pace: at time t it is the inner wind at start + scale * t.
/// With a scale of 60 an hour of record passes in a minute.
class RetimedWind final : public WindField {
public:
    /// @param inner null is calm.
    /// @param start seconds of the inner wind's time shown at time 0.
    /// @param scale seconds of the inner wind per second; 0 freezes it, a negative one runs it backwards.
    RetimedWind(WindFieldPtr inner, double start, double scale);

    glm::vec3 velocity(const glm::vec3& position, double time) const override;
    void sample(const glm::vec3* positions, std::size_t count, double time, glm::vec3* out) const override;

private:
    WindFieldPtr _inner;
    double _start;
    double _scale;
};

} // namespace osgTreeWind
