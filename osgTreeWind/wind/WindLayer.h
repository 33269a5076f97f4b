// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

namespace osgTreeWind {

/// A field of LayeredWind, which samples the field below it in blocks. A single velocity is one sample.
class WindLayer : public WindField {
public:
    glm::vec3 velocity(const WindPlace& place, double time) const final {
        glm::vec3 result;
        sample(&place, 1, time, &result);
        return result;
    }
};

} // namespace osgTreeWind
