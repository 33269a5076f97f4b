// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/Daylight.h>

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Group>

#include <optional>

enum class Shadows {
    Off,
    Soft, ///< Silhouette of each tree on the ground, which leans with the tree (GroundShadows.h).
    On,   ///< Shadow maps of the moving trees, on ground and trees (SunShadows.h).
};

struct SettingOptions {
    Shadows shadows = Shadows::Soft;
    Daylight day = Daylight();
    std::optional<osg::Vec3d> eye; ///< Grass is drawn around this point; if unset, there is no grass.
};

/// Surrounds a forest with sky, sun, haze and grassland.
osg::ref_ptr<osg::Group> createSetting(osgTreeWind::Forest& forest, const SettingOptions& options = {});
