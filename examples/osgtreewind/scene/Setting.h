// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/Daylight.h>

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Group>

#include <optional>

struct SettingOptions {
    /// Whether trees cast shadows on the ground and on trees (SunShadows.h); by default not in worlds.
    std::optional<bool> shadows;
    Daylight day = Daylight();
    std::optional<osg::Vec3d> eye; ///< Place for grass and for the exposure; if unset, there is no grass.
};

/// Surrounds a forest with sky, sun, haze and grassland.
osg::ref_ptr<osg::Group> createSetting(osgTreeWind::Forest& forest, const SettingOptions& options = {});
