// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// A wind that was read from files, and knows from which.
class FileWind final : public WindField {
public:
    struct Source {
        std::vector<std::string> files;
        bool series = false;           ///< A steady wind each, though it be one.
        std::vector<double> times;     ///< Of each of the files, seconds; empty: as they say.
        glm::dvec3 offset{0.0};        ///< From the files' coordinates to those of the world, metres.
        glm::dvec3 origin{0.0};        ///< Of the forest it was read for, in the world.
        std::string crs;               ///< Of that forest.
        double roughness = 0.0;        ///< Below the data, metres; 0: none is taken.
        double height = 0.0;           ///< Of data that do not say theirs.
        std::string speedUnit = "m/s"; ///< Of speeds where a file does not say.
    };

    /// @param wind not null.
    FileWind(WindFieldPtr wind, Source source) : _wind(std::move(wind)), _source(std::move(source)) {}

    const Source& source() const { return _source; }

    glm::vec3 velocity(const WindPlace& place, double time) const override {
        return _wind->velocity(place, time);
    }
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override {
        _wind->sample(places, count, time, out);
    }

private:
    WindFieldPtr _wind;
    Source _source;
};

} // namespace osgTreeWind
