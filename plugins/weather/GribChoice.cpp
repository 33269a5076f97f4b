// SPDX-License-Identifier: MIT
#include <plugins/weather/GribChoice.h>

#include <plugins/weather/Words.h>

#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace osgTreeWind {

namespace {

using GribMeaning::Meaning;
using GribMeaning::nameOf;
using GribMeaning::Quantity;

struct Item {
    Meaning meaning;
    const GribField* field;
};

std::string textOf(Quantity quantity, const GribLevel& level, double time) {
    return nameOf(quantity) + " at " + nameOf(level) + " at " + isoTimeText(time);
}

/// Orders levels of the same kind upward.
bool isLower(const GribLevel& a, const GribLevel& b) {
    if (a.type != b.type && a.kind == GribLevelKind::Other)
        return a.type < b.type;
    return a.kind == GribLevelKind::Isobaric ? a.value > b.value : a.value < b.value;
}

bool isSame(const GribLevel& a, const GribLevel& b) {
    return a.kind == b.kind && !isLower(a, b) && !isLower(b, a);
}

class Chooser {
public:
    Chooser(const std::vector<GribField>& fields, std::string file) : _file(std::move(file)) {
        for (const GribField& field : fields)
            if (const Meaning meaning = GribMeaning::of(field); !field.isInstantaneous)
                _hasAveragedWind = _hasAveragedWind || meaning.quantity == Quantity::East;
            else
                (field.problem.empty() ? _items : _undecodable).push_back({meaning, &field});
    }

    Result<GribChoice> choose(const std::vector<std::string>& variable) {
        keepNamed(variable);
        choosePair();
        chooseKind();
        chooseTimesAndLevels();
        chooseWind();
        chooseUp();
        chooseHeights();
        for (const Item& item : _undecodable)
            if (_problem || isNeeded(item.meaning))
                return fileProblem(_file, item.field->problem);
        if (_problem)
            return fileProblem(_file, *_problem);
        return std::move(_choice);
    }

private:
    void fail(const std::string& message) {
        if (!_problem)
            _problem = message;
    }

    bool has(Quantity quantity, std::optional<GribLevelKind> kind = {}) const {
        return std::any_of(_items.begin(), _items.end(), [&](const Item& item) {
            return item.meaning.quantity == quantity && (!kind || item.meaning.level.kind == *kind);
        });
    }

    bool isPair(GribLevelKind kind) const { return has(_first, kind) && has(_second, kind); }

    static bool isPolar(const Item& item) {
        return item.meaning.quantity == Quantity::Speed || item.meaning.quantity == Quantity::Direction;
    }
    static bool isHorizontal(const Item& item) {
        return item.meaning.quantity == Quantity::East || item.meaning.quantity == Quantity::North ||
               isPolar(item);
    }

    /// The short name, with the height above ground that ecCodes leaves out for all but the usual heights:
    /// "80u".
    static std::string shortNameOf(const GribField& field) {
        const bool isBare = field.level.kind == GribLevelKind::AboveGround && isOneOf(field.name, {"u", "v"});
        return (isBare ? numberText(field.level.value) : "") + field.name;
    }

    /// Removes the winds at levels without a field of these names.
    void keepNamed(const std::vector<std::string>& variable) {
        if (variable.empty())
            return;
        std::vector<Item> named;
        std::set<std::string> names;
        for (const Item& item : _items)
            if (isHorizontal(item)) {
                names.insert(shortNameOf(*item.field));
                if (isOneOf(shortNameOf(*item.field), variable) || isOneOf(item.field->variable, variable))
                    named.push_back(item);
            }
        if (named.empty())
            fail(expectedFound("a field of wind that wind.variable names: " +
                                   joined({names.begin(), names.end()}),
                               joined(variable)));
        const auto isUnwanted = [&](const Item& item) {
            return isHorizontal(item) && std::none_of(named.begin(), named.end(), [&](const Item& one) {
                       return isPolar(one) == isPolar(item) && isSame(one.meaning.level, item.meaning.level);
                   });
        };
        _items.erase(std::remove_if(_items.begin(), _items.end(), isUnwanted), _items.end());
    }

    void choosePair() {
        if (has(Quantity::East) && has(Quantity::North))
            return;
        if (has(Quantity::Speed) && has(Quantity::Direction)) {
            _first = Quantity::Speed;
            _second = Quantity::Direction;
            _choice.isPolar = true;
            return;
        }
        std::string found;
        for (const Quantity quantity :
             {Quantity::East, Quantity::North, Quantity::Speed, Quantity::Direction})
            if (has(quantity))
                found += (found.empty() ? "" : " and ") + nameOf(quantity);
        fail("expected fields of wind: U and V, or its speed and direction; found " +
             (!found.empty()     ? "only " + found
              : _hasAveragedWind ? "only fields averaged over a time span"
                                 : "none"));
    }

    void chooseKind() {
        if (_problem)
            return;
        const bool isobaric = has(Quantity::Height, GribLevelKind::Isobaric),
                   model = has(Quantity::Height, GribLevelKind::Model);
        std::set<GribLevelKind> pairs;
        for (const auto kind : {GribLevelKind::AboveGround, GribLevelKind::Isobaric, GribLevelKind::Model,
                                GribLevelKind::AboveSea, GribLevelKind::Surface, GribLevelKind::Other})
            if (isPair(kind))
                pairs.insert(kind);
        if (pairs.count(GribLevelKind::AboveGround))
            _kind = GribLevelKind::AboveGround;
        else if (pairs.count(GribLevelKind::Isobaric) && isobaric)
            _kind = GribLevelKind::Isobaric;
        else if (pairs.count(GribLevelKind::Model) && model)
            _kind = GribLevelKind::Model;
        else if (pairs.count(GribLevelKind::AboveSea))
            _kind = GribLevelKind::AboveSea;
        else if (pairs.size() == 1)
            _kind = *pairs.begin();
        else if (pairs.empty())
            return fail(nameOf(_first) + " and " + nameOf(_second) +
                        " are at different kinds of levels: " + osgTreeWind::textOf(*firstOf(_first)->field) +
                        ", " + osgTreeWind::textOf(*firstOf(_second)->field));
        else
            return fail("expected wind at heights above ground, or geopotential heights of its levels; found "
                        "wind at " +
                        listOf(pairs));
        pairs.erase(_kind);
        if (!pairs.empty())
            _choice.notes.push_back("the wind at " + nameOf(_kind) + " is used; that at " + listOf(pairs) +
                                    " is ignored; wind.variable chooses another by its short name");
    }

    static std::string listOf(const std::set<GribLevelKind>& kinds) {
        std::string list;
        for (const GribLevelKind kind : kinds)
            list += (list.empty() ? "" : ", ") + nameOf(kind);
        return list;
    }

    const Item* firstOf(Quantity quantity) const {
        for (const Item& item : _items)
            if (item.meaning.quantity == quantity)
                return &item;
        return nullptr;
    }

    void chooseTimesAndLevels() {
        if (_problem)
            return;
        std::size_t older = 0;
        for (const Item& item : _items)
            if (isWind(item)) {
                double& latest = _references.emplace(item.field->valid, item.field->reference).first->second;
                latest = std::max(latest, item.field->reference);
            }
        for (const Item& item : _items)
            if (isWind(item) && item.meaning.quantity == _first)
                older += item.field->reference < _references.at(item.field->valid);
        if (older > 0)
            _choice.notes.push_back("the latest forecast for each time is used; " + std::to_string(older) +
                                    " fields of " + nameOf(_first) + " from earlier forecasts are ignored");
        for (const auto& [time, reference] : _references)
            _choice.times.push_back(time);
        std::vector<GribLevel>& levels = _choice.levels;
        for (const Item& item : _items)
            if (isWind(item) && std::none_of(levels.begin(), levels.end(), [&](const GribLevel& level) {
                    return isSame(level, item.meaning.level);
                }))
                levels.push_back(item.meaning.level);
        std::sort(levels.begin(), levels.end(), isLower);
    }

    bool isWind(const Item& item) const {
        return item.meaning.level.kind == _kind &&
               (item.meaning.quantity == _first || item.meaning.quantity == _second);
    }

    /// Whether a field of this meaning would be read.
    bool isNeeded(const Meaning& meaning) const {
        const Quantity quantity = meaning.quantity;
        if (quantity == Quantity::Height)
            return _kind != GribLevelKind::AboveGround &&
                   (meaning.level.kind == _kind || meaning.level.kind == GribLevelKind::Surface);
        return meaning.level.kind == _kind &&
               (quantity == _first || quantity == _second || quantity == Quantity::Up);
    }

    /// The fields of a quantity for each time and level; null if missing.
    std::vector<const GribField*> tableOf(Quantity quantity) {
        const std::vector<double>& times = _choice.times;
        const std::vector<GribLevel>& levels = _choice.levels;
        std::vector<const GribField*> table(times.size() * levels.size(), nullptr);
        for (const Item& item : _items) {
            const auto time = std::lower_bound(times.begin(), times.end(), item.field->valid);
            const auto level = std::find_if(levels.begin(), levels.end(), [&](const GribLevel& each) {
                return isSame(each, item.meaning.level);
            });
            if (item.meaning.quantity != quantity || level == levels.end() || time == times.end() ||
                *time != item.field->valid || item.field->reference != _references.at(*time))
                continue;
            const GribField*& place =
                table[_choice.indexOf(static_cast<std::size_t>(time - times.begin()),
                                      static_cast<std::size_t>(level - levels.begin()))];
            if (place)
                fail(osgTreeWind::textOf(*item.field) +
                     " occurs twice, as in an ensemble; expected one field for each");
            place = item.field;
        }
        return table;
    }

    /// The same; a missing field is a problem.
    std::vector<const GribField*> completeTableOf(Quantity quantity) {
        std::vector<const GribField*> table = tableOf(quantity);
        if (const auto missing = std::find(table.begin(), table.end(), nullptr); missing != table.end()) {
            const auto at = static_cast<std::size_t>(missing - table.begin());
            fail(textOf(quantity, _choice.levels[at % _choice.levels.size()],
                        _choice.times[at / _choice.levels.size()]) +
                 " is missing");
        }
        return table;
    }

    void chooseWind() {
        if (_problem)
            return;
        _choice.east = completeTableOf(_first);
        _choice.north = completeTableOf(_second);
        if (_kind == GribLevelKind::AboveGround || _kind == GribLevelKind::AboveSea || hasHeights())
            return;
        if (_choice.levels.size() == 1)
            _choice.notes.push_back("the file gives no height for " + nameOf(_choice.levels.front()) +
                                    "; its wind is used at all heights");
        else
            fail("expected the geopotential heights of the " + std::to_string(_choice.levels.size()) +
                 " levels of wind at " + nameOf(_kind));
    }

    bool hasHeights() const {
        return (_kind == GribLevelKind::Isobaric || _kind == GribLevelKind::Model) &&
               has(Quantity::Height, _kind);
    }

    void chooseUp() {
        if (_problem)
            return;
        _choice.up = tableOf(Quantity::Up);
        const auto missing = std::count(_choice.up.begin(), _choice.up.end(), nullptr);
        if (missing > 0 && static_cast<std::size_t>(missing) < _choice.up.size())
            _choice.notes.emplace_back("W is not available at all levels and times and is ignored");
        if (missing > 0)
            _choice.up.clear();
        const std::vector<const GribField*> omega = tableOf(Quantity::PressureChange);
        if (missing > 0 && std::count(omega.begin(), omega.end(), nullptr) < std::ptrdiff_t(omega.size()))
            _choice.notes.emplace_back("vertical velocities in Pa/s are ignored");
    }

    void chooseHeights() {
        if (_problem || _kind == GribLevelKind::AboveGround)
            return;
        if (hasHeights()) {
            _choice.height = tableOf(Quantity::Height);
            repeatConstantHeights();
            if (!_problem && std::count(_choice.height.begin(), _choice.height.end(), nullptr) > 0)
                completeTableOf(Quantity::Height);
        } else if (_kind != GribLevelKind::AboveSea)
            return;
        for (const Item& item : _items)
            if (item.meaning.quantity == Quantity::Height &&
                item.meaning.level.kind == GribLevelKind::Surface)
                _choice.ground = item.field;
        _choice.notes.emplace_back(
            _choice.ground
                ? "heights are above the terrain of the model"
                : "the file does not contain the terrain of the model; heights are above sea level");
    }

    /// Heights of model levels that occur only once apply to all times.
    void repeatConstantHeights() {
        if (_kind != GribLevelKind::Model)
            return;
        for (std::size_t level = 0; level < _choice.levels.size(); ++level) {
            const GribField* only = nullptr;
            int count = 0;
            for (const Item& item : _items)
                if (item.meaning.quantity == Quantity::Height &&
                    isSame(item.meaning.level, _choice.levels[level])) {
                    only = item.field;
                    ++count;
                }
            for (std::size_t time = 0; count == 1 && time < _choice.times.size(); ++time)
                _choice.height[_choice.indexOf(time, level)] = only;
        }
    }

    std::string _file;
    std::vector<Item> _items, _undecodable;
    bool _hasAveragedWind = false;
    Quantity _first = Quantity::East, _second = Quantity::North;
    GribLevelKind _kind = GribLevelKind::Other;
    std::map<double, double> _references; ///< Start of the latest forecast for each time.
    GribChoice _choice;
    std::optional<std::string> _problem;
};

} // namespace

std::vector<const GribField*> GribChoice::allFields() const {
    std::vector<const GribField*> fields;
    for (const auto* part : {&east, &north, &up, &height})
        fields.insert(fields.end(), part->begin(), part->end());
    if (ground)
        fields.push_back(ground);
    return fields;
}

std::string textOf(const GribField& field) {
    const Meaning meaning = GribMeaning::of(field);
    return textOf(meaning.quantity, meaning.level, field.valid);
}

Result<GribChoice> chooseGribWind(const std::vector<GribField>& fields, const std::string& file,
                                  const std::vector<std::string>& variable) {
    return Chooser(fields, file).choose(variable);
}

} // namespace osgTreeWind
