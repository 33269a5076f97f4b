// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/Daylight.h>

#include <osgTreeWind/nodes/Forest.h>

#include <osg/Group>

#include <optional>

enum class Shadows {
    Off,
    Soft, ///< A silhouette of each tree on the ground (GroundShadows.h), which leans with it.
    On,   ///< Shadow maps (SunShadows.h): they move with the trees and fall on them too.
};

struct SettingOptions {
    Shadows shadows = Shadows::Soft;
    Daylight day = Daylight();
    std::optional<osg::Vec3d> eye; ///< About which grass stands in tufts; none: nowhere.
};

/// Sky, sun, haze and grassland around a forest.
osg::ref_ptr<osg::Group> createSetting(osgTreeWind::Forest& forest, const SettingOptions& options = {});
