// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindWithSources.h>

#include <osgTreeWind/wind/SourceFlow.h>

#include <algorithm>
#include <utility>

namespace osgTreeWind {

WindWithSources::WindWithSources(WindFieldPtr wind, std::vector<WindSource> sources)
    : _wind(std::move(wind)), _sources(std::move(sources)) {
    if (const auto before = std::dynamic_pointer_cast<const WindWithSources>(_wind)) {
        _wind = before->_wind;
        _sources.insert(_sources.begin(), before->_sources.begin(), before->_sources.end());
    }
    _mean = _wind ? _wind->withoutGusts() : nullptr;
    if (!_mean)
        _mean = _wind;
    for (const WindSource& source : _sources)
        _flows.emplace_back(source);
}

WindWithSources::~WindWithSources() = default;

glm::vec3 WindWithSources::velocity(const WindPlace& place, double time) const {
    glm::vec3 sum;
    sample(&place, 1, time, &sum);
    return sum;
}

void WindWithSources::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    if (_wind)
        _wind->sample(places, count, time, out);
    else
        std::fill_n(out, count, glm::vec3(0.0f));
    for (std::size_t i = 0; i < count; ++i) {
        float share = 1.0f;
        glm::vec3 added(0.0f);
        for (const SourceFlow& flow : _flows) {
            share *= flow.shareOfWind(places[i], time);
            added += flow.velocity(places[i], time, _mean.get());
        }
        out[i] = share * out[i] + added;
    }
}

WindFieldPtr WindWithSources::withoutGusts() const {
    const WindFieldPtr mean = _wind ? _wind->withoutGusts() : nullptr;
    std::vector<WindSource> steady = _sources;
    bool isGusty = mean != nullptr;
    for (WindSource& source : steady) {
        isGusty = isGusty || source.turbulence > 0.0;
        source.turbulence = 0.0;
    }
    return isGusty ? std::make_shared<WindWithSources>(mean ? mean : _wind, std::move(steady)) : nullptr;
}

WindFieldPtr WindWithSources::changedBesideSources(const WindChange& change) const {
    return std::make_shared<WindWithSources>(change(_wind), _sources);
}

} // namespace osgTreeWind
