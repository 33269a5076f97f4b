// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

/// Expects finite velocities at extreme places and times, the same from velocity() and sample().
inline void expectFiniteEverywhere(const osgTreeWind::WindField& wind) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> odd = {0.0f, -0.0f, 0.5f, -1.0f, 1e-40f, 1e30f, -1e30f, 3.4e38f, inf, -inf, nan};
    std::vector<osgTreeWind::WindPlace> places;
    for (float x : odd)
        for (float y : odd)
            for (float z : odd)
                for (float ground : {0.0f, -40.0f, inf, nan})
                    places.emplace_back(glm::vec3(x, y, z), ground);
    std::vector<glm::vec3> sampled(places.size());
    for (double time : {0.0, -1.0, 0.3, 1e30, -1e300, double(inf), -double(inf), double(nan)}) {
        wind.sample(places.data(), places.size(), time, sampled.data());
        for (std::size_t i = 0; i < places.size(); ++i) {
            const glm::vec3& at = places[i].position;
            const glm::vec3 v = wind.velocity(places[i], time);
            ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z))
                << "at " << at.x << ' ' << at.y << ' ' << at.z << ", time " << time;
            ASSERT_EQ(v, sampled[i]) << "at " << at.x << ' ' << at.y << ' ' << at.z << ", time " << time;
        }
    }
}
