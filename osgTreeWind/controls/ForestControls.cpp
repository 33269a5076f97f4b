// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/ForestControls.h>

#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/controls/FormattedText.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/species/SeasonDay.h>
#include <osgTreeWind/wind/WindKeys.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr double stepTime = 1.0 / 30.0, minClockRate = 1.0 / 64.0; // seconds; simulation time over real time

/// The date of a season (Season.h).
std::string dateText(float season) {
    const std::string date = isoTimeText(86400.0 * dayOfSeason(season)); // in 1970
    constexpr const char* months[] = {"January", "February", "March",     "April",   "May",      "June",
                                      "July",    "August",   "September", "October", "November", "December"};
    return std::to_string(std::stoi(date.substr(8, 2))) + ' ' + months[std::stoi(date.substr(5, 2)) - 1];
}

/// Whether two winds have the same field, adjustment and gusts.
bool hasSameField(const Wind& a, const Wind& b) {
    return a.field == b.field && areKeysEqual(a.adjustment, b.adjustment) && areKeysEqual(a.gusts, b.gusts);
}

/// Copies the field, the adjustment and the gusts of a wind.
void copyField(const Wind& other, Wind& wind) {
    wind.field = other.field;
    wind.adjustment = other.adjustment;
    wind.gusts = other.gusts;
}

/// The sources of nextSource() in order: a helicopter of 7 t 15 m above the tree, a fan that blows from the
/// west, a vortex beside the tree, a shelter around it, and 100 kg of TNT 15 m west of it that explode after
/// 1 s. Parameters as of nextSource().
std::vector<WindSource> placeableSources(const glm::dvec3& foot, double height, double time) {
    WindSource helicopter; // a Super Puma's rotor
    helicopter.position = foot + glm::dvec3(0.0, 0.0, height + 15.0);
    helicopter.radius = 7.8;
    helicopter.thrust = 70000.0;
    WindSource fan;
    fan.kind = WindSource::Kind::Jet;
    fan.position = foot + glm::dvec3(-height, 0.0, 0.6 * height);
    fan.toward = glm::half_pi<float>();
    fan.radius = 2.0;
    fan.speed = 30.0;
    WindSource vortex;
    vortex.kind = WindSource::Kind::Vortex;
    vortex.position = foot + glm::dvec3(5.0, 0.0, 0.0);
    vortex.radius = 4.0;
    vortex.speed = 15.0;
    vortex.height = 2.0 * height;
    WindSource shelter;
    shelter.kind = WindSource::Kind::Shelter;
    shelter.position = foot;
    shelter.radius = 10.0;
    shelter.height = 1.2 * height;
    shelter.share = 0.1;
    WindSource explosion;
    explosion.kind = WindSource::Kind::Explosion;
    explosion.position = foot + glm::dvec3(-15.0, 0.0, 0.0);
    explosion.charge = 100.0;
    explosion.time = time + 1.0;
    return {helicopter, fan, vortex, shelter, explosion};
}

} // namespace

ForestControls::ForestControls(Forest* forest) : _forest(forest) {}

void ForestControls::keepError(const Diagnostics& problems) {
    _error = problems.empty() ? "" : problems.front().text();
}

void ForestControls::steerWind(const std::function<void(WindSteering&)>& change) {
    if (!_forest.valid())
        return;
    Wind now = _forest->getWind();
    if (!_isSteering || !hasSameField(now, _modifiedWind)) {
        _hostWind = now;
        _steering = steeringOf(now);
        _isSteering = true;
    }
    change(_steering);
    _modifiedWind = steered(_hostWind, _steering);
    copyField(_modifiedWind, now);
    keepError(_forest->setWind(std::move(now)));
}

void ForestControls::changeSpeed(double metresPerSecond) {
    steerWind([&](WindSteering& wind) { wind.strengthen(metresPerSecond); });
}

void ForestControls::turnWind(double degrees) {
    steerWind([&](WindSteering& wind) { wind.turnClockwise(degrees); });
}

void ForestControls::changeGustiness(double by) {
    steerWind([&](WindSteering& wind) { wind.changeGustiness(by); });
}

void ForestControls::restoreWind() {
    _error.clear();
    if (_forest.valid() && _isSteering) {
        Wind now = _forest->getWind();
        copyField(_hostWind, now);
        keepError(_forest->setWind(std::move(now)));
    }
    _isSteering = false;
}

void ForestControls::changeSources(const std::function<void(std::vector<WindSource>&)>& change) {
    if (!_forest.valid())
        return;
    Wind wind = _forest->getWind();
    change(wind.sources);
    keepError(_forest->setWind(std::move(wind)));
}

void ForestControls::nextSource(const glm::dvec3& foot, double height, double time) {
    changeSources([&](std::vector<WindSource>& sources) {
        const std::vector<WindSource> choice = placeableSources(foot, height, time);
        const bool isPlaced =
            _placedSource && !sources.empty() && sources.back().kind == choice[*_placedSource].kind;
        if (isPlaced)
            sources.pop_back();
        _placedSource = isPlaced ? *_placedSource + 1 : 0;
        if (*_placedSource < choice.size())
            sources.push_back(choice[*_placedSource]);
        else
            _placedSource.reset();
    });
}

void ForestControls::removeSource() {
    changeSources([](std::vector<WindSource>& sources) {
        if (!sources.empty())
            sources.pop_back();
    });
    _placedSource.reset();
}

void ForestControls::toggleTierColors() {
    if (!_forest.valid())
        return;
    osg::StateSet* state = _forest->getOrCreateStateSet();
    if (state->getDefinePair("TIERS_COLORED")) {
        state->removeDefine("TIERS_COLORED");
    } else {
        state->setDefine("TIERS_COLORED");
        state->getOrCreateUniform("tierColor", osg::Uniform::FLOAT_VEC3)->set(osg::Vec3(1.0f, 1.0f, 1.0f));
    }
}

void ForestControls::changeSeason(float seasons) {
    if (_forest.valid())
        keepError(
            _forest->setSeason(wrapSeason(0.01f * std::round(100.0f * (_forest->getSeason() + seasons)))));
}

void ForestControls::rebuildForest(const std::function<void(ForestDescription&)>& change) {
    if (!_forest.valid())
        return;
    ForestDescription description = _forest->getSimulation().currentDescription();
    change(description);
    keepError(_forest->setDescription(std::move(description)));
}

void ForestControls::nextLaw() {
    rebuildForest([](ForestDescription& forest) { // modal, thesis, thesis-smooth
        forest.law = static_cast<MotionLaw>((static_cast<int>(forest.law) + 1) % 3);
    });
}

void ForestControls::changeGain(float factor) {
    rebuildForest([factor](ForestDescription& forest) {
        forest.gain = std::clamp(factor * std::max(forest.gain, 0.1f), 0.0f, 100.0f);
    });
}

void ForestControls::toggleDamage() {
    rebuildForest([](ForestDescription& forest) { forest.damage = !forest.damage; });
}

void ForestControls::toggleTiers() {
    rebuildForest([](ForestDescription& forest) { forest.drawing.tiers = !forest.drawing.tiers; });
}

void ForestControls::toggleBudget() {
    constexpr float budget = 33.0f; // milliseconds
    rebuildForest([](ForestDescription& forest) {
        forest.drawing.budget = forest.drawing.budget > 0.0f ? 0.0f : budget;
    });
}

void ForestControls::step() {
    _isPaused = true;
    ++_pendingSteps;
}

void ForestControls::changeClockRate(double factor) {
    _clockRate = std::clamp(_clockRate * factor, minClockRate, 1.0 / minClockRate);
}

double ForestControls::simulationTime(double referenceTime) {
    if (!(std::abs(referenceTime) <= maxTime))
        return _time;
    const double passed = _lastReferenceTime ? std::max(referenceTime - *_lastReferenceTime, 0.0) : 0.0;
    _lastReferenceTime = referenceTime;
    _time += _isPaused ? _pendingSteps * stepTime : passed * _clockRate;
    _pendingSteps = 0;
    return _time;
}

std::string ForestControls::windText() const {
    const Wind wind = _forest->getWind();
    const std::string sources =
        wind.sources.empty() ? "" : formatted(" and %zu sources", wind.sources.size());
    if (!wind.field)
        return "calm" + sources;
    const WindSteering steering = steeringOf(wind);
    std::string text = "of the host";
    if (steering.isSynthetic)
        text = formatted("%.1f m/s from %.0f\xc2\xb0", steering.speed, steering.from);
    if (steering.strength != 1.0)
        text += formatted(", times %.3g", steering.strength);
    if (steering.turn != 0.0)
        text += formatted(", turned by %.0f\xc2\xb0", steering.turn);
    if (steering.isSynthetic || steering.gustiness > 0.0)
        text += formatted(", gusts %.0f %%", 100.0 * steering.gustiness);
    return text + sources;
}

std::string ForestControls::text() const {
    if (!_forest.valid())
        return {};
    const ForestDescription& forest = _forest->getDescription();
    std::string text = "wind    " + windText() + "\nseason  " + dateText(_forest->getSeason()) +
                       "\nlaw     " + wordOf(forest.law);
    if (forest.gain != 1.0f)
        text += ", gain " + numberText(std::round(100.0 * static_cast<double>(forest.gain)) / 100.0);
    if (forest.damage)
        text += ", with damage";
    if (!forest.drawing.tiers)
        text += ", all trees in full detail";
    if (forest.drawing.budget > 0.0f)
        text += formatted(", budget %.3g ms", static_cast<double>(forest.drawing.budget));
    const osg::StateSet* state = _forest->getStateSet();
    if (state && state->getDefinePair("TIERS_COLORED"))
        text += "\ncolours red: full detail; yellow to green: boughs; blue: pictures; violet: far tiles";
    text += formatted("\ntime    %.1f s", _time);
    if (_isPaused)
        text += ", paused";
    else if (_clockRate != 1.0)
        text += formatted(", x %.3g", _clockRate);
    return text;
}

} // namespace osgTreeWind
