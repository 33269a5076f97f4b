// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/LayeredWind.h>

#include <osgTreeWind/wind/GustyWind.h>
#include <osgTreeWind/wind/SourceGrid.h>
#include <osgTreeWind/wind/WindFiles.h>
#include <osgTreeWind/wind/WindLayer.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
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

/// A field of a wind with the wind's clock, map and adjustment.
class AdjustedField final : public WindLayer {
public:
    AdjustedField(std::shared_ptr<const Wind> wind, WindFieldPtr field)
        : _wind(std::move(wind)), _field(std::move(field)), _map(mapOf(*_wind)),
          _adjust(_wind->adjustment.matrix()), _isAdjusted(!_wind->adjustment.isIdentity()) {}

    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override {
        if (_map)
            sampleInBlocks(
                places, count, [this](const WindPlace& place) { return _map->toData(place); },
                [&](std::size_t first, const WindPlace* at, std::size_t some) {
                    sampleField(at, some, time, out + first);
                    for (std::size_t i = first; i < first + some; ++i)
                        out[i] = _map->toScene(places[i], out[i]);
                });
        else
            sampleField(places, count, time, out);
        if (_isAdjusted)
            std::transform(out, out + count, out, [this](const glm::vec3& v) { return _adjust * v; });
    }

private:
    void sampleField(const WindPlace* at, std::size_t count, double time, glm::vec3* velocities) const {
        const WindClock& clock = _wind->clock;
        if (!clock.travels())
            return _field->sample(at, count, clock.at({}, time), velocities);
        for (std::size_t i = 0; i < count; ++i)
            velocities[i] = _field->velocity(at[i], clock.at(glm::dvec2(at[i].position), time));
    }

    std::shared_ptr<const Wind> _wind;
    WindFieldPtr _field;
    const DataTransform* _map;
    glm::mat3 _adjust;
    bool _isAdjusted;
};

/// Transforms between the forest's frame and that of its wind.
struct FrameChange {
    glm::dmat4 toWind{1.0};   ///< Transforms places to the wind's frame.
    glm::dmat3 turnBack{1.0}; ///< Turns velocities to the forest's frame.
    double heightScale = 1.0; ///< Scales heights to the wind's frame.
    bool isIdentity = true;

    FrameChange(WindFrame frame, const glm::dmat4& forestToScene)
        : isIdentity(frame == WindFrame::Forest || forestToScene == glm::dmat4(1.0)) {
        if (isIdentity)
            return;
        toWind = forestToScene;
        turnBack = glm::transpose(rotationOf(forestToScene));
        heightScale = frame == WindFrame::Geocentric ? glm::length(glm::dvec3(toWind[2])) : toWind[2].z;
    }

    WindPlace toWindFrame(const WindPlace& place) const {
        if (isIdentity)
            return place;
        WindPlace moved = place;
        moved.position = glm::vec3(toWind * glm::dvec4(glm::dvec3(place.position), 1.0));
        moved.height = static_cast<float>(heightScale * static_cast<double>(place.height));
        return moved;
    }
    WindPlace toForestFrame(const WindPlace& place) const {
        if (isIdentity)
            return place;
        WindPlace moved = place;
        moved.position = glm::vec3(glm::inverse(toWind) * glm::dvec4(glm::dvec3(place.position), 1.0));
        moved.height =
            heightScale != 0.0 ? static_cast<float>(static_cast<double>(place.height) / heightScale) : 0.0f;
        return moved;
    }
    glm::vec3 turnedBack(const glm::vec3& velocity) const {
        return isIdentity ? velocity : glm::vec3(turnBack * glm::dvec3(velocity));
    }
    glm::vec3 turnedToWind(const glm::vec3& velocity) const {
        return isIdentity ? velocity : glm::vec3(glm::transpose(turnBack) * glm::dvec3(velocity));
    }
};

/// A field in the wind's frame, at places in the forest's frame.
class FieldInForest final : public WindLayer {
public:
    FieldInForest(const FrameChange& frame, WindFieldPtr field) : _frame(frame), _field(std::move(field)) {}

    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override {
        sampleInBlocks(
            places, count, [this](const WindPlace& place) { return _frame.toWindFrame(place); },
            [&](std::size_t first, const WindPlace* at, std::size_t some) {
                _field->sample(at, some, time, out + first);
                for (std::size_t i = first; i < first + some; ++i)
                    out[i] = _frame.turnedBack(out[i]);
            });
    }

private:
    FrameChange _frame;
    WindFieldPtr _field;
};

/// Adds sources to a wind in the forest's frame.
class WindWithSources final : public WindLayer {
public:
    /// @param below null: calm. @param ambient deflects the flow of sources: in the forest's frame if
    /// `isAmongTrees`, else in the wind's; null: calm.
    WindWithSources(const std::vector<WindSource>& sources, const FrameChange& frame, WindFieldPtr below,
                    WindFieldPtr ambient, bool isAmongTrees)
        : _sources(sources), _frame(frame), _below(std::move(below)), _ambient(std::move(ambient)),
          _isAmongTrees(isAmongTrees) {}

    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override {
        if (_below)
            _below->sample(places, count, time, out);
        else
            std::fill_n(out, count, glm::vec3(0.0f));
        struct AmbientWind {
            std::uint32_t source = ~0u;
            float ground = 0.0f;
            glm::vec3 velocity{0.0f};
        } cache[32]; // the ambient wind of a source is the same for all places on level ground
        const std::shared_ptr<const SourceGrid::Cells> cells = _sources.at(time);
        for (std::size_t i = 0; i < count; ++i) {
            const WindPlace place = _frame.toWindFrame(places[i]);
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
            out[i] = share * out[i] + _frame.turnedBack(added);
        }
    }

private:
    /// In the wind's frame.
    glm::vec3 ambientWindAt(const WindPlace& place, double time) const {
        if (!_ambient)
            return glm::vec3(0.0f);
        if (!_isAmongTrees)
            return _ambient->velocity(place, time);
        return _frame.turnedToWind(_ambient->velocity(_frame.toForestFrame(place), time));
    }

    SourceGrid _sources;
    FrameChange _frame;
    WindFieldPtr _below, _ambient;
    bool _isAmongTrees;
};

} // namespace

LayeredWind::LayeredWind(std::shared_ptr<const Wind> wind, const glm::dmat4& forestToScene,
                         std::shared_ptr<const CanopyMap> canopy, std::uint32_t seed) {
    const FrameChange frame(wind->frame, forestToScene);
    const bool isPlain = !mapOf(*wind) && wind->adjustment.isIdentity() && wind->clock.isIdentity();
    const auto adjusted = [&](const WindFieldPtr& field) -> WindFieldPtr {
        return isPlain || !field ? field : std::make_shared<AdjustedField>(wind, field);
    };
    const auto inForest = [&](const WindFieldPtr& field) -> WindFieldPtr {
        return frame.isIdentity || !field ? field : std::make_shared<FieldInForest>(frame, field);
    };
    const WindFieldPtr mean = adjusted(wind->field), meanInForest = inForest(mean);
    const auto gusty = [&](const WindFieldPtr& below, const WindFieldPtr& turbulence) {
        return std::make_shared<GustyWind>(below, turbulence, wind->gusts, wind->field->profile(),
                                           wind->clock);
    };
    if (!mean || !(wind->gusts.intensity > 0.0))
        _top = meanInForest;
    else if (wind->frame == WindFrame::Geocentric) // only the forest's frame has an axis that points upward
        _top = gusty(meanInForest, inForest(adjusted(wind->field->turbulence())));
    else
        _top = inForest(gusty(mean, adjusted(wind->field->turbulence())));
    if (canopy && mean) {
        _canopy = std::make_shared<CanopyFlow>(_top, meanInForest, std::move(canopy), seed);
        _top = _canopy;
    }
    if (!wind->sources.empty())
        _top = std::make_shared<WindWithSources>(wind->sources, frame, _top, _canopy ? _canopy : mean,
                                                 _canopy != nullptr);
}

void LayeredWind::sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const {
    if (_top)
        _top->sample(places, count, time, out);
    else
        std::fill_n(out, count, glm::vec3(0.0f));
}

WindFieldPtr asField(const Wind& wind) {
    return LayeredWind(std::make_shared<const Wind>(wind)).top();
}

} // namespace osgTreeWind
