// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/motion/laws/Reconfiguration.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

/// What the trees of a species are drawn with under the law `modal`.
struct SpeciesLooks {
    osg::ref_ptr<osg::StateSet> bark, leaves, impostors;
    /// A person's own, applied after these; null: none. One with a program of its own replaces ours.
    osg::ref_ptr<osg::StateSet> ownBark, ownLeaves;
    Reconfiguration foliage;

    /// From now on the colours of a season. What was there before is left as it is: copies share it.
    void showSeason(const Appearance& appearance, float season);
};

/// On the colour of leaves as they are in summer.
osg::Vec3 seasonTint(const Appearance& appearance, float season);

/// State sets of their own, with programs and textures that others share.
SpeciesLooks makeSpeciesLooks(const Species& species);

} // namespace osgTreeWind
