// SPDX-License-Identifier: MIT
#include <osgTreeWind/controls/ForestControls.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/controls/FormattedText.h>
#include <osgTreeWind/forest/ForestFields.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/species/Season.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr double frameTime = 1.0 / 30.0, slowest = 1.0 / 64.0; // seconds; over real time

/// A date within the year that the season is that of (Season.h).
std::string dateText(float season) {
    constexpr double daysInSeason = 365.0 / 4.0, midwinter = 34.0; // from the first of January
    const std::time_t day = std::lround(midwinter + daysInSeason * static_cast<double>(season));
    const std::time_t seconds = 86400 * day; // of 1970
    std::tm date{};
    gmtime_r(&seconds, &date);
    char month[32];
    std::strftime(month, sizeof month, "%B", &date);
    return std::to_string(date.tm_mday) + ' ' + month;
}

/// Whether both have the same field, as strong and turned alike.
bool sameAir(const Wind& a, const Wind& b) {
    return a.field == b.field && a.adjustment.strength == b.adjustment.strength &&
           a.adjustment.turn == b.adjustment.turn;
}

/// Gives a wind the field and the adjustment of another one.
void blowAs(const Wind& other, Wind& wind) {
    wind.field = other.field;
    wind.adjustment = other.adjustment;
}

/// What a person may put to a tree, one after the other: a helicopter of seven tonnes 15 m above it, a fan
/// that blows at it from the west, a whirl beside it, a place out of the wind around it, a hundred kilograms
/// of TNT 15 m west of it that go off a second later.
/// @param foot of the tree, in the wind's frame. @param height of the tree, metres. @param time now, seconds.
std::vector<WindSource> sourcesByHand(const glm::dvec3& foot, double height, double time) {
    WindSource helicopter; // a Super Puma's rotor
    helicopter.position = foot + glm::dvec3(0.0, 0.0, height + 15.0);
    helicopter.radius = 7.8;
    helicopter.thrust = 70000.0;
    WindSource fan;
    fan.kind = WindSource::Kind::Jet;
    fan.position = foot + glm::dvec3(-height, 0.0, 0.6 * height);
    fan.toward = 90.0;
    fan.radius = 2.0;
    fan.speed = 30.0;
    WindSource whirl;
    whirl.kind = WindSource::Kind::Vortex;
    whirl.position = foot + glm::dvec3(5.0, 0.0, 0.0);
    whirl.radius = 4.0;
    whirl.speed = 15.0;
    whirl.height = 2.0 * height;
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
    return {helicopter, fan, whirl, shelter, explosion};
}

} // namespace

ForestControls::ForestControls(Forest* forest) : _forest(forest) {}

void ForestControls::steer(const std::function<void(WindSteering&)>& change) {
    if (!_forest.valid())
        return;
    _message.clear();
    Wind now = _forest->getWind();
    if (!_steers || !sameAir(now, _set)) {
        _given = now;
        _steering = steeringOf(now);
        _steers = true;
    }
    change(_steering);
    _set = steered(_given, _steering);
    blowAs(_set, now);
    _forest->setWind(std::move(now));
}

void ForestControls::changeSpeed(double metresPerSecond) {
    steer([&](WindSteering& wind) { wind.strengthen(metresPerSecond); });
}

void ForestControls::turnWind(double degrees) {
    steer([&](WindSteering& wind) { wind.turnClockwise(degrees); });
}

void ForestControls::changeGustiness(double by) {
    steer([&](WindSteering& wind) { wind.changeGustiness(by); });
}

void ForestControls::restoreWind() {
    if (_forest.valid() && _steers) {
        Wind now = _forest->getWind();
        blowAs(_given, now);
        _forest->setWind(std::move(now));
    }
    _steers = false;
    _message.clear();
}

void ForestControls::changeSources(const std::function<void(std::vector<WindSource>&)>& change) {
    if (!_forest.valid())
        return;
    Wind wind = _forest->getWind();
    change(wind.sources);
    _forest->setWind(std::move(wind));
}

void ForestControls::nextSource(const glm::dvec3& foot, double height, double time) {
    changeSources([&](std::vector<WindSource>& sources) {
        const std::vector<WindSource> choice = sourcesByHand(foot, height, time);
        const bool isThere = _byHand && !sources.empty() && sources.back().kind == choice[*_byHand].kind;
        if (isThere)
            sources.pop_back();
        _byHand = isThere ? *_byHand + 1 : 0;
        if (*_byHand < choice.size())
            sources.push_back(choice[*_byHand]);
        else
            _byHand.reset();
    });
}

void ForestControls::removeSource() {
    changeSources([](std::vector<WindSource>& sources) {
        if (!sources.empty())
            sources.pop_back();
    });
    _byHand.reset();
}

void ForestControls::switchTierColors() {
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
        _forest->setSeason(withinYear(0.01f * std::round(100.0f * (_forest->getSeason() + seasons))));
}

void ForestControls::grow(const std::function<void(ForestDescription&)>& change) {
    if (!_forest.valid())
        return;
    ForestDescription description = _forest->getSimulation().describe();
    change(description);
    const Diagnostics problems = _forest->setDescription(std::move(description));
    _message = problems.empty() ? "" : problems.front().text();
}

void ForestControls::nextLaw() {
    grow([](ForestDescription& forest) { // modal, thesis, thesis-smooth
        forest.law = static_cast<MotionLaw>((static_cast<int>(forest.law) + 1) % 3);
    });
}

void ForestControls::changeGain(float factor) {
    grow([factor](ForestDescription& forest) {
        forest.gain = std::clamp(factor * std::max(forest.gain, 0.1f), 0.0f, 100.0f);
    });
}

void ForestControls::switchDamage() {
    grow([](ForestDescription& forest) { forest.damage = !forest.damage; });
}

void ForestControls::switchTiers() {
    grow([](ForestDescription& forest) { forest.drawing.tiers = !forest.drawing.tiers; });
}

void ForestControls::switchBudget() {
    constexpr float budget = 33.0f; // milliseconds
    grow([](ForestDescription& forest) {
        forest.drawing.budget = forest.drawing.budget > 0.0f ? 0.0f : budget;
    });
}

void ForestControls::step() {
    _isPaused = true;
    ++_steps;
}

void ForestControls::changePace(double factor) {
    _pace = std::clamp(_pace * factor, slowest, 1.0 / slowest);
}

double ForestControls::simulationTime(double referenceTime) {
    if (!(std::abs(referenceTime) <= maxTime))
        return _time;
    const double passed = _reference ? std::max(referenceTime - *_reference, 0.0) : 0.0;
    _reference = referenceTime;
    _time += _isPaused ? _steps * frameTime : passed * _pace;
    _steps = 0;
    return _time;
}

std::string ForestControls::windText() const {
    const Wind wind = _forest->getWind();
    const std::string sources =
        wind.sources.empty() ? "" : formatted(" and %zu sources", wind.sources.size());
    if (!wind.field)
        return "calm" + sources;
    const WindSteering steering = steeringOf(wind);
    if (steering.isMadeUp)
        return formatted("%.1f m/s from %.0f\xc2\xb0, gusts %.0f %%", steering.speed, steering.from,
                         100.0 * steering.gustiness) +
               sources;
    std::string text = "as given";
    if (steering.strength != 1.0)
        text += formatted(", times %.3g", steering.strength);
    if (steering.turn != 0.0)
        text += formatted(", turned by %.0f\xc2\xb0", steering.turn);
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
        text += ", all in full";
    if (forest.drawing.budget > 0.0f)
        text += formatted(", budget %.3g ms", static_cast<double>(forest.drawing.budget));
    const osg::StateSet* state = _forest->getStateSet();
    if (state && state->getDefinePair("TIERS_COLORED"))
        text += "\ncolours red: in full; yellow to green: by boughs; blue: pictures; violet: far tiles";
    text += formatted("\ntime    %.1f s", _time);
    if (_isPaused)
        text += ", paused";
    else if (_pace != 1.0)
        text += formatted(", x %.3g", _pace);
    return text;
}

} // namespace osgTreeWind
