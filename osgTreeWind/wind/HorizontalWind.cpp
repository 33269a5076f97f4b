// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/HorizontalWind.h>

namespace osgTreeWind {

glm::vec3 hourlyMean(const WindField& wind, float height) {
    constexpr int samples = 60;
    glm::dvec3 sum(0.0);
    for (int i = 0; i < samples; ++i) {
        const glm::vec3 velocity = wind.velocity(WindPlace(0.0f, 0.0f, height), 60.0 * i);
        if (HorizontalWind(velocity).speed > 0.0f)
            sum += glm::dvec3(velocity.x, velocity.y, 0.0f);
    }
    return glm::vec3(sum / static_cast<double>(samples));
}

} // namespace osgTreeWind
