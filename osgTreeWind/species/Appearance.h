// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include <optional>
#include <string>

namespace osgTreeWind {

/// What the sprays on a leaf texture are made of, by genus.
enum class LeafForm {
    Blade,    ///< Plain pointed blades: any broadleaf.
    Lobed,    ///< Oak.
    Ovate,    ///< Beech, hornbeam, elm.
    Rhombic,  ///< Birch.
    Palmate,  ///< Maple, plane.
    Pinnate,  ///< Ash, honey locust: leaflets along a stalk.
    Heart,    ///< Lime.
    Round,    ///< Aspen, poplar.
    Fingered, ///< Horse chestnut: leaflets like fingers.
    Fan,      ///< Ginkgo.
    Needles,  ///< Spruce, fir: combs.
    Bundles,  ///< Pine.
    Tufts,    ///< Larch.
    Frond,    ///< Palm.
    Pointed,  ///< Red oak: lobes with teeth.
};
constexpr int leafForms = 15;

constexpr bool isNeedles(LeafForm form) {
    return form >= LeafForm::Needles && form <= LeafForm::Tufts;
}

/// What the surface of bark is like.
enum class BarkForm {
    Furrowed, ///< Ridges along the stem: oak, ash, any tree.
    Plated,   ///< Long plates that flake: pine.
    Smooth,   ///< Beech.
    Banded,   ///< Birch: white, with dark bands across.
    Flaking,  ///< Plane: patches of several colours.
    Ringed,   ///< Palm.
    Scaly,    ///< Small thin scales: spruce.
};

/// How a kind of tree looks. Linear RGB colours, each in [0, 1].
struct Appearance {
    glm::vec3 bark{0.18f, 0.15f, 0.12f};         ///< Of the stem.
    glm::vec3 leaves{0.13f, 0.21f, 0.05f};       ///< In summer.
    glm::vec3 springLeaves{0.19f, 0.29f, 0.06f}; ///< As they unfold,
    glm::vec3 autumnLeaves{0.32f, 0.17f, 0.03f}; ///< and before they fall.
    float underside =
        1.15f; ///< Luminance of the underside of leaves over the upper one's; what is more is grey.
    std::optional<bool> evergreen;          ///< Not given: as the form of its leaves says.
    LeafForm leafForm = LeafForm::Blade;    ///< Of leaves.
    BarkForm barkForm = BarkForm::Furrowed; ///< Of the stem.
    std::string leafImage; ///< A picture file to take instead of what we paint: drawing/looks/TreePicture.h.
    std::string barkImage; ///< Likewise, of bark.

    /// Of twigs: darker than the bark of the stem, and never white.
    glm::vec3 twigs() const {
        return barkForm == BarkForm::Banded ? glm::vec3(0.06f, 0.035f, 0.028f) : 0.6f * bark;
    }
    bool needles() const { return isNeedles(leafForm); } ///< Rather than blades.
    /// Green in winter.
    bool isEvergreen() const {
        return evergreen.value_or((needles() && leafForm != LeafForm::Tufts) || leafForm == LeafForm::Frond);
    }
};

} // namespace osgTreeWind
