// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/SpeciesLooks.h>

#include <osgTreeWind/base/Luminance.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/motion/laws/StatelessFlutter.h>
#include <osgTreeWind/species/Season.h>
#include <osgTreeWind/species/SpeciesKeys.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace osgTreeWind {
namespace {

/// Hairs, wax and air below the epidermis scatter light of all wavelengths equally.
glm::vec3 undersideOverUpper(const Appearance& appearance) {
    const glm::vec3 upper = glm::max(appearance.leaves, glm::vec3(1e-3f));
    return 1.0f + (appearance.underside - 1.0f) * luminance(upper) / upper;
}

} // namespace

SpeciesLooks makeSpeciesLooks(const Species& species) {
    const Appearance& appearance = species.appearance;
    SpeciesLooks looks{new osg::StateSet, new osg::StateSet, new osg::StateSet,
                       nullptr,           nullptr,           Reconfiguration(species)};
    configureBark(*looks.bark, sharedProgram("instance_bark", "bark"), appearance);
    configureLeaves(*looks.leaves, sharedProgram("instance_leaf", "leaf"), appearance);
    const glm::vec4 limits = flutterLimits(species.leaf);
    looks.leaves->addUniform(
        new osg::Uniform("flutterLimits", osg::Vec4(limits.x, limits.y, limits.z, limits.w)));
    const glm::vec2 tremble = leafTremble(species.leaf);
    looks.leaves->addUniform(new osg::Uniform("leafTremble", osg::Vec2(tremble.x, tremble.y)));
    const osg::ref_ptr<osg::Uniform> limberness =
        new osg::Uniform("limberness", clampedKeys(species.leaf).shootSway);
    looks.leaves->addUniform(limberness);
    looks.bark->addUniform(limberness);
    looks.leaves->addUniform(new osg::Uniform("leafUnderside", toOsg(undersideOverUpper(appearance))));
    return looks;
}

void SpeciesLooks::showSeason(const Appearance& appearance, float season) {
    leaves = new osg::StateSet(*leaves);
    const glm::vec3 mean = leafColor(appearance, season);
    leaves->addUniform(new osg::Uniform("leafColor", toOsg(mean)));
    leaves->addUniform(new osg::Uniform(
        "leafFresh", toOsg(shootColor(appearance, season) / glm::max(mean, glm::vec3(1e-3f)) - 1.0f)));
    impostors = new osg::StateSet(*impostors);
    impostors->addUniform(new osg::Uniform("leafTint", seasonTint(appearance, season)));
}

osg::Vec3 seasonTint(const Appearance& appearance, float season) {
    return toOsg(leafColor(appearance, season) / glm::max(appearance.leaves, glm::vec3(1e-3f)));
}

} // namespace osgTreeWind
