// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindSampler.h>

#include <osgTreeWind/wind/WindInternals.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t placesInBlock = 64;

/// The matrix without scale and shear; the identity for a degenerate one.
glm::dmat3 rotationOf(const glm::dmat4& matrix) {
    const glm::dvec3 z(matrix[2]), x = glm::dvec3(matrix[0]);
    const glm::dvec3 y = glm::cross(z, x);
    if (!(glm::length(y) > 0.0))
        return glm::dmat3(1.0);
    const glm::dvec3 up = glm::normalize(z), north = glm::normalize(y);
    return {glm::cross(north, up), north, up};
}

bool isInAnotherFrame(WindFrame frame, const glm::dmat4& forestToScene) {
    return frame != WindFrame::Forest && forestToScene != glm::dmat4(1.0);
}

/// Transforms places and samples the results block by block.
template <typename Transform, typename Sample>
void sampleInBlocks(const WindPlace* places, std::size_t count, Transform transform, Sample sample) {
    WindPlace moved[placesInBlock];
    for (std::size_t first = 0; first < count; first += placesInBlock) {
        const std::size_t some = std::min(placesInBlock, count - first);
        std::transform(places + first, places + first + some, moved, transform);
        sample(first, moved, some);
    }
}

} // namespace

/// The wind without canopy and sources, of the field or of `_mean`.
class WindSampler::AboveCanopy final : public WindField {
public:
    AboveCanopy(const WindSampler& sampler, const WindField& field) : _sampler(sampler), _field(field) {}
    glm::vec3 velocity(const WindPlace& place, double time) const override {
        glm::vec3 result;
        _sampler.sampleOpen(_field, &place, 1, time, &result);
        return result;
    }
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override {
        _sampler.sampleOpen(_field, places, count, time, out);
    }

private:
    const WindSampler& _sampler;
    const WindField& _field;
};

WindSampler::WindSampler(std::shared_ptr<const Wind> wind, const glm::dmat4& forestToScene,
                         std::shared_ptr<const CanopyMap> canopy)
    : _wind(std::move(wind)), _mean(_wind->field ? _wind->field->withoutGusts() : nullptr),
      _adjust(_wind->adjustment.matrix()), _isAdjusted(!_wind->adjustment.isIdentity()),
      _isInAnotherFrame(isInAnotherFrame(_wind->frame, forestToScene)), _toWind(forestToScene),
      _turnBack(glm::transpose(rotationOf(forestToScene))), _sources(_wind->sources) {
    if (!_mean)
        _mean = _wind->field;
    _heightScale = _wind->frame == WindFrame::Geocentric ? glm::length(glm::dvec3(_toWind[2])) : _toWind[2].z;
    if (canopy && _wind->field)
        _canopy = std::make_shared<CanopyFlow>(AboveCanopy(*this, *_mean), std::move(canopy),
                                               _wind->canopy.value_or(WindCanopy()).seed);
}

glm::vec3 WindSampler::velocity(const WindPlace& place, double time) const {
    glm::vec3 result;
    sample(&place, 1, time, &result);
    return result;
}

void WindSampler::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    if (_canopy)
        _canopy->sample(AboveCanopy(*this, *_wind->field), AboveCanopy(*this, *_mean), places, count, time,
                        out);
    else if (_wind->field)
        sampleOpen(*_wind->field, places, count, time, out);
    else
        std::fill_n(out, count, glm::vec3(0.0f));
    if (!_sources.isEmpty())
        addSources(places, count, time, out);
}

WindPlace WindSampler::toWindFrame(const WindPlace& place) const {
    if (!_isInAnotherFrame)
        return place;
    WindPlace moved = place;
    moved.position = glm::vec3(_toWind * glm::dvec4(glm::dvec3(place.position), 1.0));
    moved.height = static_cast<float>(_heightScale * static_cast<double>(place.height));
    return moved;
}

/// Samples a field in the wind's frame.
void WindSampler::sampleData(const WindField& field, const WindPlace* places, std::size_t count, double time,
                             glm::vec3* out) const {
    const WindClock& clock = _wind->clock;
    const auto sampleField = [&](const WindPlace* at, std::size_t some, glm::vec3* velocities) {
        if (!clock.travels())
            return field.sample(at, some, clock.at({}, time), velocities);
        for (std::size_t i = 0; i < some; ++i)
            velocities[i] = field.velocity(at[i], clock.at(glm::dvec2(at[i].position), time));
    };
    if (const WindMap* map = WindInternals::map(*_wind))
        sampleInBlocks(
            places, count, [map](const WindPlace& place) { return map->toData(place); },
            [&](std::size_t first, const WindPlace* at, std::size_t some) {
                sampleField(at, some, out + first);
                for (std::size_t i = first; i < first + some; ++i)
                    out[i] = map->toScene(places[i], out[i]);
            });
    else
        sampleField(places, count, out);
    if (_isAdjusted)
        std::transform(out, out + count, out, [this](const glm::vec3& v) { return _adjust * v; });
}

/// Samples a field in the forest's frame, without canopy and sources.
void WindSampler::sampleOpen(const WindField& field, const WindPlace* places, std::size_t count, double time,
                             glm::vec3* out) const {
    if (!_isInAnotherFrame)
        return sampleData(field, places, count, time, out);
    sampleInBlocks(
        places, count, [this](const WindPlace& place) { return toWindFrame(place); },
        [&](std::size_t first, const WindPlace* at, std::size_t some) {
            sampleData(field, at, some, time, out + first);
            for (std::size_t i = first; i < first + some; ++i)
                out[i] = glm::vec3(_turnBack * glm::dvec3(out[i]));
        });
}

/// The wind that deflects the flow of a source, in the wind's frame.
glm::vec3 WindSampler::ambientWindAt(const WindPlace& place, double time) const {
    glm::vec3 air(0.0f);
    if (!_canopy) {
        if (_mean)
            sampleData(*_mean, &place, 1, time, &air);
        return air;
    }
    WindPlace here = place;
    if (_isInAnotherFrame) {
        here.position = glm::vec3(glm::inverse(_toWind) * glm::dvec4(glm::dvec3(place.position), 1.0));
        here.height =
            _heightScale != 0.0 ? static_cast<float>(static_cast<double>(place.height) / _heightScale) : 0.0f;
    }
    _canopy->sample(AboveCanopy(*this, *_wind->field), AboveCanopy(*this, *_mean), &here, 1, time, &air);
    return _isInAnotherFrame ? glm::vec3(glm::transpose(_turnBack) * glm::dvec3(air)) : air;
}

void WindSampler::addSources(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    struct AmbientWind {
        std::uint32_t source = ~0u;
        float ground = 0.0f;
        glm::vec3 velocity{0.0f};
    } cache[32]; // the ambient wind of a source is the same for all places on level ground
    const std::shared_ptr<const SourceGrid::Cells> cells = _sources.at(time);
    for (std::size_t i = 0; i < count; ++i) {
        const WindPlace place = toWindFrame(places[i]);
        const float ground = place.position.z - place.height;
        float share = 1.0f;
        glm::vec3 added(0.0f);
        for (const std::uint32_t source : cells->near(place.position)) {
            const SourceFlow& flow = _sources.flows()[source];
            if (!flow.reaches(place, time))
                continue;
            share *= flow.shareOfWind(place, time);
            AmbientWind& ambient = cache[source % 32];
            if (flow.isDeflectedByWind() && !(ambient.source == source && ambient.ground == ground))
                ambient = {source, ground, ambientWindAt(flow.ambientWindPlace(ground, time), time)};
            added += flow.velocity(place, time, ambient.velocity);
        }
        out[i] = share * out[i] + (_isInAnotherFrame ? glm::vec3(_turnBack * glm::dvec3(added)) : added);
    }
}

WindFieldPtr asField(const Wind& wind) {
    return asField(std::make_shared<const Wind>(wind), glm::dmat4(1.0));
}

WindFieldPtr asField(std::shared_ptr<const Wind> wind, const glm::dmat4& forestToScene) {
    if (wind->isCalm())
        return nullptr;
    const bool isPlain = wind->sources.empty() && !WindInternals::map(*wind) &&
                         wind->adjustment.isIdentity() && wind->clock.isIdentity() &&
                         !isInAnotherFrame(wind->frame, forestToScene);
    return isPlain ? wind->field : std::make_shared<WindSampler>(std::move(wind), forestToScene);
}

} // namespace osgTreeWind
