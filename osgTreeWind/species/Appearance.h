// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include <optional>
#include <string>

namespace osgTreeWind {

/// Shape of the leaves that sprays on a leaf texture are painted with, and typical genera.
enum class LeafForm {
    Blade,    ///< Plain pointed blades: broadleaves in general.
    Lobed,    ///< Oak.
    Ovate,    ///< Beech, hornbeam, elm.
    Rhombic,  ///< Birch.
    Palmate,  ///< Maple, plane.
    Pinnate,  ///< Ash, honey locust: leaflets along a stalk.
    Heart,    ///< Lime.
    Round,    ///< Aspen, poplar.
    Fingered, ///< Horse chestnut: palmate leaflets.
    Fan,      ///< Ginkgo.
    Needles,  ///< Spruce, Douglas fir: needles on all sides of the shoots.
    Bundles,  ///< Pine: long needles at the ends of the shoots.
    Tufts,    ///< Larch: rosettes of needles.
    Frond,    ///< Palm.
    Pointed,  ///< Red oak: pointed lobes.
    Combed,   ///< Fir, hemlock: needles on two sides of the shoots.
};
constexpr int leafFormCount = 16;

constexpr bool isNeedles(LeafForm form) {
    return (form >= LeafForm::Needles && form <= LeafForm::Tufts) || form == LeafForm::Combed;
}

/// Surface of bark.
enum class BarkForm {
    Furrowed, ///< Ridges along the stem: oak, ash, trees in general.
    Plated,   ///< Long plates that flake: pine.
    Smooth,   ///< Beech.
    Banded,   ///< Birch: white, with dark bands across.
    Flaking,  ///< Plane: patches of several colours.
    Ringed,   ///< Palm.
    Scaly,    ///< Small thin scales: spruce.
};

/// Appearance of a species. Colours are linear RGB, each component in [0, 1].
struct Appearance {
    glm::vec3 bark{0.18f, 0.15f, 0.12f};         ///< Bark of the stem.
    std::optional<glm::vec3> oldBark;            ///< Thick bark at the foot of old stems; see oldBarkColor().
    glm::vec3 leaves{0.13f, 0.21f, 0.05f};       ///< Leaves in summer.
    glm::vec3 springLeaves{0.19f, 0.29f, 0.06f}; ///< Unfolding leaves.
    glm::vec3 autumnLeaves{0.32f, 0.17f, 0.03f}; ///< Leaves before they fall.
    float underside = 1.15f;       ///< Luminance of a leaf's underside / upper side; the excess is grey.
    std::optional<bool> evergreen; ///< By default it follows from `leafForm`; see isEvergreen().
    LeafForm leafForm = LeafForm::Blade;    ///< Form of the leaves.
    BarkForm barkForm = BarkForm::Furrowed; ///< Pattern of the bark.
    std::string leafImage; ///< Image file instead of painted leaves; see drawing/looks/TreePicture.h.
    std::string barkImage; ///< The same for bark.

    /// `oldBark`, or by default `bark`, and nearly black if that is banded.
    glm::vec3 oldBarkColor() const {
        return oldBark.value_or(barkForm == BarkForm::Banded ? glm::vec3(0.075f, 0.06f, 0.05f) : bark);
    }
    /// Colour of twigs: darker than old bark, and never white.
    glm::vec3 twigColor() const { return 0.42f * oldBarkColor(); }
    /// Whether the leaves are needles rather than blades or fronds.
    bool hasNeedles() const { return isNeedles(leafForm); }
    /// Whether it keeps its leaves in winter: `evergreen`, or by default whether it has fronds, or needles
    /// other than tufts.
    bool isEvergreen() const {
        return evergreen.value_or((hasNeedles() && leafForm != LeafForm::Tufts) ||
                                  leafForm == LeafForm::Frond);
    }
};

} // namespace osgTreeWind
