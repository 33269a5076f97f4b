// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/LeafSpray.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/drawing/looks/LeafOutlines.h>
#include <osgTreeWind/drawing/looks/SprayCoverage.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

/// How twigs branch and bear leaves. Lengths in widths of the card, angles in radians.
struct Habit {
    int sides = 7, twigs = 3, ends = 1; ///< Side shoots of the stem, of each of those, and so on.
    float lean = 0.9f;                  ///< Angle between a shoot and its parent.
    bool opposite = false;              ///< Whether shoots and leaves grow in pairs instead of alternating.
    float bare = 0.1f;                  ///< Share of a shoot without leaves, from its foot.
    float spacing = 0.05f;              ///< Distance of leaves along a shoot.
    float leafLean = 0.9f;              ///< Angle between a leaf and its shoot.
    float length = 0.15f;               ///< Length of a blade.
    float petiole = 0.02f;              ///< Length of a petiole.
    float tilt = 0.8f;                  ///< Largest angle between a leaf and the card; not of needles.
};

/// @param lean clockwise from upright, radians.
glm::vec2 direction(float lean) {
    return {math::sin(lean), math::cos(lean)};
}

struct Shoot {
    glm::vec2 foot;
    float lean, bend, length, width;

    float leanAt(float t) const { return lean + bend * t; }
    glm::vec2 at(float t) const { return foot + length * t * direction(lean + 0.5f * bend * t); }
};

/// By form. Fronds use the tilt only.
constexpr Habit habits[] = {
    {7, 3, 1, 0.9f, false, 0.1f, 0.03f, 0.9f, 0.16f, 0.02f, 0.7f},     // blade
    {7, 3, 1, 1.0f, false, 0.2f, 0.03f, 0.9f, 0.22f, 0.01f, 0.6f},     // lobed
    {8, 3, 1, 0.8f, false, 0.1f, 0.04f, 0.85f, 0.14f, 0.02f, 0.3f},    // ovate: flat, in two rows
    {9, 4, 1, 0.7f, false, 0.05f, 0.03f, 0.9f, 0.095f, 0.03f, 1.2f},   // rhombic
    {6, 3, 1, 0.9f, true, 0.2f, 0.07f, 0.9f, 0.25f, 0.09f, 0.5f},      // palmate
    {6, 2, 1, 0.8f, true, 0.2f, 0.05f, 0.7f, 0.11f, 0.27f, 0.55f},     // pinnate: stout and few
    {8, 3, 1, 0.9f, false, 0.1f, 0.04f, 0.9f, 0.175f, 0.05f, 0.55f},   // heart
    {8, 3, 1, 0.8f, false, 0.1f, 0.03f, 0.9f, 0.105f, 0.07f, 0.7f},    // round
    {6, 2, 0, 0.8f, true, 0.1f, 0.1f, 1.2f, 0.26f, 0.13f, 0.45f},      // fingered: stout and few
    {8, 2, 0, 1.0f, false, 0.1f, 0.05f, 0.9f, 0.13f, 0.07f, 0.9f},     // fan: bunches on spurs
    {12, 1, 0, 0.85f, true, 0.0f, 0.006f, 0.9f, 0.05f, 0.0f, 0.0f},    // needles: brushes
    {6, 2, 0, 0.7f, true, 0.35f, 0.008f, 0.6f, 0.16f, 0.0f, 0.0f},     // bundles: at the ends of shoots
    {9, 3, 0, 0.9f, false, 0.05f, 0.045f, 1.2f, 0.065f, 0.0f, 0.0f},   // tufts: rosettes on spurs
    {0, 0, 0, 0.0f, false, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.3f},        // frond
    {7, 3, 1, 1.0f, false, 0.2f, 0.035f, 0.9f, 0.245f, 0.025f, 0.55f}, // pointed
    {10, 1, 0, 0.9f, true, 0.0f, 0.006f, 1.25f, 0.06f, 0.0f, 0.0f},    // combed: needles to both sides
};

/// Whether a point is inside a rounded square, which hides the shape of the card.
bool isOnCard(const glm::vec2& p) {
    const glm::vec2 off = glm::abs(p - 0.5f) / 0.495f;
    return math::pow(off.x, 5.0f) + math::pow(off.y, 5.0f) < 1.0f;
}

/// A leaf of one or more blades.
struct Leaf {
    std::size_t first, end; ///< Range of its blades.
    float rank;             ///< Leaves are added in ascending order.
};

class SprayGrower {
public:
    SprayGrower(LeafForm form, int variant, float share)
        : _form(form), _share(share), _habit(habits[static_cast<std::size_t>(form)]),
          _outline(leafOutline(form)),
          _random(100 + static_cast<std::uint64_t>(form) + 1000 * static_cast<std::uint64_t>(variant)) {}

    LeafSpray spray() {
        if (_form == LeafForm::Frond)
            growFrond();
        else
            grow();
        LeafSpray spray;
        for (const Shoot& shoot : _shoots)
            for (int i = 0; i < 6; ++i) {
                const float from = static_cast<float>(i) / 6.0f, to = static_cast<float>(i + 1) / 6.0f;
                spray.twigs.push_back({shoot.at(from), shoot.at(to), shoot.width * (1.0f - 0.6f * from),
                                       shoot.width * (1.0f - 0.6f * to)});
            }
        std::stable_sort(_leaves.begin(), _leaves.end(),
                         [](const Leaf& a, const Leaf& b) { return a.rank < b.rank; });
        SprayCoverage cover;
        spray.twigs = cover.fitTwigs(std::move(spray.twigs), _share * twigCoverage(_form));
        // Leaves grow toward the light: first those with the most free space.
        const float wanted = _share * leafCoverage(_form);
        for (const float room : isNeedles(_form) ? std::vector{0.0f} : std::vector{0.75f, 0.4f, 0.0f})
            for (Leaf& leaf : _leaves)
                if (cover.leafShare() < wanted && hasRoom(cover, leaf, room))
                    for (; leaf.first < leaf.end; ++leaf.first) {
                        cover.addLeaf(_outline, _blades[leaf.first]);
                        spray.blades.push_back(_blades[leaf.first]);
                    }
        // Leaves at the back are darker.
        std::stable_sort(spray.blades.begin(), spray.blades.end(),
                         [](const LeafBlade& a, const LeafBlade& b) { return a.brightness < b.brightness; });
        return spray;
    }

private:
    bool hasRoom(SprayCoverage& cover, const Leaf& leaf, float room) const {
        float sum = 0.0f;
        for (std::size_t i = leaf.first; i < leaf.end; ++i)
            sum += cover.freeShare(_outline, _blades[i]);
        return sum >= room * static_cast<float>(leaf.end - leaf.first);
    }

    void grow() {
        const Shoot stem{{0.5f, 0.0f}, 0.1f * _random.symmetric(), 0.15f * _random.symmetric(), 0.8f, 1.6f};
        _shoots.push_back(stem);
        const std::vector<Shoot> sides = sideShoots(stem, _habit.sides, 0.04f, 0.85f, 0.6f, 1.2f);
        for (const Shoot& side : sides) {
            _shoots.push_back(side);
            for (const Shoot& twig : sideShoots(side, _habit.twigs, 0.2f, 0.9f, 0.22f, 1.0f)) {
                _shoots.push_back(twig);
                for (const Shoot& end : sideShoots(twig, _habit.ends, 0.3f, 0.8f, 0.12f, 0.9f))
                    _bareShoots.push_back(end);
            }
        }
        for (const Shoot& shoot : _shoots)
            if (isNeedles(_form))
                addNeedles(shoot);
            else
                addLeaves(shoot, &shoot == &_shoots.front() ? 0.5f : _habit.bare);
        _shoots.insert(_shoots.end(), _bareShoots.begin(), _bareShoots.end());
    }

    /// @param reach typical length of a shoot.
    std::vector<Shoot> sideShoots(const Shoot& parent, int count, float from, float to, float reach,
                                  float width) {
        std::vector<Shoot> shoots;
        float hand = _random.uniform() < 0.5f ? -1.0f : 1.0f;
        for (int i = 0; i < count; ++i, hand = -hand) {
            const int step = _habit.opposite ? i / 2 * 2 : i;
            const float t = from + (to - from) * (static_cast<float>(step) + 0.3f * _random.uniform()) /
                                       static_cast<float>(std::max(count - 1, 1));
            const glm::vec2 foot = parent.at(t);
            const float lean = parent.leanAt(t) + hand * (_habit.lean + 0.15f * _random.symmetric());
            Shoot shoot{foot, lean, -hand * 0.35f * _random.uniform(),
                        reach * tapering(t) * (0.55f + 0.7f * _random.uniform()), width};
            while (shoot.length > 0.03f && !isOnCard(shoot.at(1.0f)))
                shoot.length *= 0.9f;
            if (shoot.length > 0.03f)
                shoots.push_back(shoot);
        }
        return shoots;
    }

    /// Sprays of conifers are pointed.
    float tapering(float t) const {
        return isNeedles(_form) && _form != LeafForm::Bundles ? 1.1f - 0.75f * t : 1.0f;
    }

    void addLeaves(const Shoot& shoot, float bare) {
        const float start = bare * shoot.length;
        float hand = _random.uniform() < 0.5f ? -1.0f : 1.0f;
        for (float at = start; at < shoot.length; at += _habit.spacing, hand = -hand) {
            const float t = at / shoot.length;
            const float lean = _habit.leafLean * (1.0f - 0.35f * t);
            addLeaf(shoot.at(t), shoot.leanAt(t), hand * lean);
            if (_habit.opposite)
                addLeaf(shoot.at(t), shoot.leanAt(t), -hand * lean);
        }
        addLeaf(shoot.at(1.0f), shoot.leanAt(1.0f), 0.0f);
    }

    /// Adds needles on all sides of a shoot; those in front are brighter.
    void addNeedles(const Shoot& shoot) {
        const int perPlace = _form == LeafForm::Tufts ? 40 : 5;
        for (float at = _habit.bare * shoot.length; at < shoot.length; at += _habit.spacing) {
            const float t = at / shoot.length;
            const bool end = at + _habit.spacing >= shoot.length;
            for (int i = 0; i < perPlace; ++i)
                addNeedle(shoot.at(t), shoot.leanAt(t),
                          end ? _random.uniform() * _habit.leafLean : _habit.leafLean);
        }
    }

    /// @param shoot lean of the shoot. @param lean of the needle relative to it.
    void addNeedle(const glm::vec2& foot, float shoot, float lean) {
        float around = glm::pi<float>() * _random.symmetric();
        if (_form == LeafForm::Combed)
            around = 0.35f * around + (_random.uniform() < 0.5f ? glm::pi<float>() : 0.0f);
        lean *= 1.0f + 0.25f * _random.symmetric();
        const float aside = math::sin(lean) * math::cos(around), front = math::sin(lean) * math::sin(around);
        const float own = shoot + math::atan2(aside, math::cos(lean));
        const float length = _habit.length * (0.8f + 0.35f * _random.uniform());
        if (!fits(foot, own, length))
            return;
        _hue = 0.5f + 0.3f * _random.symmetric();
        _brightness = 0.62f + 0.24f * front + 0.1f * _random.symmetric();
        _tilt = math::asin(glm::clamp(glm::abs(front), 0.0f, 0.98f));
        _toward = own;
        _leaves.push_back({_blades.size(), _blades.size() + 1, _random.uniform()});
        addBlade(foot, own, length);
    }

    /// @param shoot lean of the shoot. @param lean of the leaf relative to it.
    void addLeaf(const glm::vec2& foot, float shoot, float lean) {
        const float size = 0.8f + 0.35f * _random.uniform();
        const glm::vec2 off = 0.04f * glm::vec2(_random.symmetric(), _random.symmetric());
        for (int attempt = 0; attempt < 3; ++attempt) {
            const float own = shoot + lean + 0.6f * _random.symmetric();
            const glm::vec2 place = foot + off + size * _habit.petiole * direction(own);
            if (!fits(place, own, size * _habit.length))
                continue;
            turnFace();
            _hue = 0.5f + 0.4f * _random.symmetric();
            const std::size_t first = _blades.size();
            addBlades(foot + off, place, own, size * _habit.length);
            _leaves.push_back({first, _blades.size(), _random.uniform()});
            return;
        }
    }

    /// Sets a random orientation of the next leaf. Leaves that face upward see more of the sky.
    void turnFace() {
        _tilt = _habit.tilt * _random.uniform();
        _toward = glm::pi<float>() * _random.symmetric();
        _brightness =
            (0.55f + 0.37f * _random.uniform()) * (1.0f + 0.25f * math::sin(_tilt) * math::cos(_toward));
    }

    void addBlades(const glm::vec2& foot, const glm::vec2& place, float lean, float length) {
        const glm::vec2 way = place - foot;
        switch (_form) {
        case LeafForm::Pinnate:
            for (int i = 0; i < 5; ++i) {
                const glm::vec2 at = foot + (0.25f + 0.18f * static_cast<float>(i)) * way;
                addBlade(at, lean + 0.95f, length * 0.85f);
                addBlade(at, lean - 0.95f, length * 0.85f);
            }
            break;
        case LeafForm::Fingered:
            for (int i = -3; i <= 3; ++i)
                addBlade(place, lean + 0.6f * static_cast<float>(i),
                         length * (1.0f - 0.14f * static_cast<float>(std::abs(i))));
            return;
        case LeafForm::Fan:
            addBlade(foot + 0.6f * way, lean + 0.9f, length);
            addBlade(foot + 0.8f * way, lean - 0.7f, length);
            break;
        default:
            break;
        }
        addBlade(place, lean, length);
    }

    void addBlade(const glm::vec2& foot, float lean, float length) {
        if (_form == LeafForm::Frond || fits(foot, lean, length))
            _blades.push_back({foot, lean, length, _brightness, _hue, _tilt, _toward});
    }

    bool fits(const glm::vec2& foot, float lean, float length) const {
        const glm::vec2 along = length * direction(lean), side{along.y, -along.x};
        return std::all_of(_outline.begin(), _outline.end(), [&](const glm::vec2& p) {
            return isOnCard(foot + p.y * along + p.x * side) && isOnCard(foot + p.y * along - p.x * side);
        });
    }

    /// A segment of a frond: leaflets on a rib along the lower edge, which lean toward the end of the rib.
    /// The segment before it on the rib reaches into it.
    void growFrond() {
        _shoots.push_back({{0.0f, 0.01f}, glm::half_pi<float>(), 0.0f, 1.0f, 1.0f});
        constexpr int leaflets = 24;
        for (int i = -leaflets / 2; i < leaflets; ++i) {
            const float at = (static_cast<float>(i) + 0.5f + 0.3f * _random.symmetric()) / leaflets;
            turnFace();
            const std::size_t first = _blades.size();
            const float length = 0.98f - 0.15f * _random.uniform(), lean = 0.5f + 0.12f * _random.symmetric();
            addBlade({at, 0.005f}, lean, length);
            _leaves.push_back({first, _blades.size(), _random.uniform()});
        }
    }

    LeafForm _form;
    float _share;
    Habit _habit;
    LeafOutline _outline;
    Random _random;
    std::vector<Shoot> _shoots, _bareShoots;
    std::vector<LeafBlade> _blades;
    std::vector<Leaf> _leaves;
    float _brightness = 0.8f, _hue = 0.5f, _tilt = 0.0f, _toward = 0.0f; ///< Of the next leaf.
};

} // namespace

LeafSpray growSpray(LeafForm form, int variant, float share) {
    return SprayGrower(form, variant, share).spray();
}

} // namespace osgTreeWind
