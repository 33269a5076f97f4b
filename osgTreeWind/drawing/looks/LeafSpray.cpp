// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/LeafSpray.h>

#include <osgTreeWind/drawing/looks/LeafOutlines.h>
#include <osgTreeWind/model/Random.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

/// How twigs branch and bear leaves. Lengths in widths of the card, angles in radians.
struct Habit {
    int sides = 7, twigs = 3; ///< Side shoots of the stem; twigs of each of them.
    float lean = 0.9f;        ///< Of a shoot from its parent.
    bool opposite = false;    ///< Shoots and leaves in pairs, or by turns.
    float bare = 0.1f;        ///< Part of a shoot that bears no leaves, from its foot.
    float spacing = 0.05f;    ///< Of leaves along a shoot.
    float leafLean = 0.9f;    ///< Of a leaf from its shoot.
    float length = 0.15f;     ///< Of a blade.
    float petiole = 0.02f;
    float variation = 0.3f; ///< Of a leaf's direction.
};

/// @param lean from upright toward the right.
glm::vec2 direction(float lean) {
    return {glm::sin(lean), glm::cos(lean)};
}

struct Shoot {
    glm::vec2 foot;
    float lean, bend, length, width;

    float leanAt(float t) const { return lean + bend * t; }
    glm::vec2 at(float t) const { return foot + length * t * direction(lean + 0.5f * bend * t); }
};

/// By form; that of a frond is not used.
constexpr Habit habits[] = {
    {7, 3, 0.9f, false, 0.1f, 0.05f, 0.9f, 0.15f, 0.02f, 0.3f},    // blade
    {7, 3, 1.0f, false, 0.4f, 0.05f, 0.9f, 0.2f, 0.01f, 0.3f},     // lobed: leaves crowd at the ends
    {7, 3, 0.8f, false, 0.1f, 0.06f, 0.85f, 0.16f, 0.02f, 0.12f},  // ovate: flat, in two rows
    {7, 4, 0.7f, false, 0.1f, 0.035f, 0.9f, 0.1f, 0.035f, 0.3f},   // rhombic
    {6, 2, 0.9f, true, 0.3f, 0.15f, 0.9f, 0.19f, 0.1f, 0.3f},      // palmate
    {6, 2, 0.9f, true, 0.4f, 0.12f, 0.7f, 0.14f, 0.34f, 0.3f},     // pinnate
    {7, 3, 0.9f, false, 0.1f, 0.08f, 0.9f, 0.15f, 0.06f, 0.5f},    // heart
    {7, 3, 0.8f, false, 0.1f, 0.05f, 0.9f, 0.1f, 0.08f, 0.6f},     // round
    {6, 1, 0.9f, true, 0.25f, 0.35f, 1.2f, 0.22f, 0.16f, 0.3f},    // fingered
    {7, 3, 1.0f, false, 0.1f, 0.13f, 0.9f, 0.12f, 0.08f, 0.2f},    // fan: bunches on spurs
    {9, 5, 0.8f, false, 0.0f, 0.006f, 0.9f, 0.04f, 0.0f, 0.15f},   // needles
    {7, 3, 0.75f, false, 0.3f, 0.007f, 0.55f, 0.13f, 0.0f, 0.25f}, // bundles
    {7, 4, 0.9f, false, 0.1f, 0.035f, 0.9f, 0.055f, 0.0f, 0.3f},   // tufts
    {7, 3, 0.9f, false, 0.1f, 0.05f, 0.9f, 0.15f, 0.02f, 0.3f},    // frond
};

/// Within a rounded outline that the eye does not take for a card.
bool onCard(const glm::vec2& p) {
    const glm::vec2 off = glm::abs(p - 0.5f) / 0.495f;
    return std::pow(off.x, 2.6f) + std::pow(off.y, 2.6f) < 1.0f;
}

class Spray {
public:
    explicit Spray(LeafForm form)
        : _form(form), _habit(habits[static_cast<std::size_t>(form)]), _outline(leafOutline(form)),
          _random(100 + static_cast<std::uint64_t>(form)) {}

    LeafTexels paint() {
        if (_form == LeafForm::Frond)
            growFrond();
        else
            grow();
        std::vector<TwigPiece> pieces;
        for (const Shoot& shoot : _shoots)
            for (int i = 0; i < 6; ++i) {
                const float from = static_cast<float>(i) / 6.0f, to = static_cast<float>(i + 1) / 6.0f;
                pieces.push_back({shoot.at(from), shoot.at(to), shoot.width * (1.0f - 0.6f * from),
                                  shoot.width * (1.0f - 0.6f * to)});
            }
        SprayCanvas canvas;
        canvas.addTwigs(std::move(pieces), twigCoverage(_form));
        // What hangs behind is darker.
        std::stable_sort(_blades.begin(), _blades.end(),
                         [](const LeafBlade& a, const LeafBlade& b) { return a.brightness < b.brightness; });
        for (const LeafBlade& blade : _blades)
            canvas.addLeaf(_outline, blade);
        return canvas.texels();
    }

private:
    void grow() {
        const Shoot stem{{0.5f, 0.0f}, 0.1f * _random.symmetric(), 0.15f * _random.symmetric(), 0.8f, 2.4f};
        _shoots.push_back(stem);
        const std::vector<Shoot> sides = sideShoots(stem, _habit.sides, 0.04f, 0.85f, 0.55f, 1.5f);
        for (const Shoot& side : sides) {
            _shoots.push_back(side);
            for (const Shoot& twig : sideShoots(side, _habit.twigs, 0.2f, 0.9f, 0.22f, 1.0f)) {
                _shoots.push_back(twig);
                for (const Shoot& end : sideShoots(twig, 2, 0.3f, 0.8f, 0.09f, 0.7f))
                    _bareShoots.push_back(end);
            }
        }
        for (const Shoot& shoot : _shoots)
            addLeaves(shoot, &shoot == &_shoots.front() ? 0.5f : _habit.bare);
        _shoots.insert(_shoots.end(), _bareShoots.begin(), _bareShoots.end());
    }

    /// @param reach of the longest.
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
                        reach * (0.75f + 0.4f * _random.uniform()), width};
            while (shoot.length > 0.03f && !onCard(shoot.at(1.0f)))
                shoot.length *= 0.9f;
            if (shoot.length > 0.03f)
                shoots.push_back(shoot);
        }
        return shoots;
    }

    void addLeaves(const Shoot& shoot, float bare) {
        const float start = bare * shoot.length;
        float hand = _random.uniform() < 0.5f ? -1.0f : 1.0f;
        for (float at = start; at < shoot.length; at += _habit.spacing, hand = -hand) {
            const float t = at / shoot.length;
            const float lean = _habit.leafLean * (1.0f - 0.35f * t);
            addLeaf(shoot.at(t), shoot.leanAt(t), hand * lean);
            if (_habit.opposite || _form >= LeafForm::Needles)
                addLeaf(shoot.at(t), shoot.leanAt(t), -hand * lean);
        }
        addLeaf(shoot.at(1.0f), shoot.leanAt(1.0f), 0.0f);
    }

    /// @param lean from the shoot.
    void addLeaf(const glm::vec2& foot, float shoot, float lean) {
        const float size = 0.8f + 0.35f * _random.uniform();
        for (int attempt = 0; attempt < 3; ++attempt) {
            const float own = shoot + lean + _habit.variation * _random.symmetric();
            const glm::vec2 place = foot + size * _habit.petiole * direction(own);
            if (!fits(place, own, size * _habit.length))
                continue;
            _brightness = 0.52f + 0.48f * _random.uniform();
            _hue = 0.5f + 0.4f * _random.symmetric();
            addBlades(foot, place, own, size * _habit.length);
            return;
        }
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
        case LeafForm::Tufts:
            for (int i = -6; i <= 6; ++i)
                addBlade(place, lean + 0.25f * static_cast<float>(i),
                         length * (0.8f + 0.3f * _random.uniform()));
            return;
        default:
            break;
        }
        addBlade(place, lean, length);
    }

    void addBlade(const glm::vec2& foot, float lean, float length) {
        if (_form == LeafForm::Frond)
            while (length > 0.05f && !fits(foot, lean, length))
                length *= 0.9f;
        if (fits(foot, lean, length))
            _blades.push_back({foot, lean, length, _brightness, _hue});
    }

    bool fits(const glm::vec2& foot, float lean, float length) const {
        const glm::vec2 along = length * direction(lean), side{along.y, -along.x};
        return std::all_of(_outline.begin(), _outline.end(), [&](const glm::vec2& p) {
            return onCard(foot + p.y * along + p.x * side) && onCard(foot + p.y * along - p.x * side);
        });
    }

    /// A midrib up the card, leaflets on both sides, the longest below the middle.
    void growFrond() {
        const Shoot rib{{0.5f, 0.0f}, 0.0f, 0.0f, 0.97f, 1.0f};
        _shoots.push_back(rib);
        constexpr int pairs = 70;
        for (int i = 0; i < pairs; ++i) {
            const float t = 0.06f + 0.92f * static_cast<float>(i) / pairs;
            const float lean = glm::mix(1.25f, 0.35f, t * t), reach = glm::mix(0.5f, 0.16f, t * t * t);
            for (const float hand : {-1.0f, 1.0f}) {
                _brightness = 0.52f + 0.48f * _random.uniform();
                addBlade(rib.at(t), hand * (lean + 0.06f * _random.symmetric()),
                         reach * glm::min(1.0f, 0.45f + 3.0f * t));
            }
        }
    }

    LeafForm _form;
    Habit _habit;
    LeafOutline _outline;
    Random _random;
    std::vector<Shoot> _shoots, _bareShoots;
    std::vector<LeafBlade> _blades;
    float _brightness = 0.8f, _hue = 0.5f; ///< Of the leaf that is being added.
};

} // namespace

LeafTexels paintSpray(LeafForm form) {
    return Spray(form).paint();
}

} // namespace osgTreeWind
