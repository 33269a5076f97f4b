// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/species/Species.h>

#include <osg/Image>

#include <glm/vec2.hpp>

#include <vector>

namespace osgTreeWind {

/// From where and how finely pictures of a tree are painted; ranges are not checked.
struct ImpostorSettings {
    int azimuths = 8;    ///< Evenly around the tree, [4, 32].
    int elevations = 4;  ///< Evenly from the horizon to the zenith, [2, 8].
    int pixels = 64;     ///< Width and height of a picture, a power of two, [32, 512].
    int samples = 2;     ///< A pixel has this number squared, [1, 4].
    float leaves = 1.0f; ///< Share of its leaves that the tree bears, [0, 1].
};

/// Pictures of one tree at rest, side by side in two images: azimuths from left to right, the first seen from
/// +x and so on counter-clockwise; elevations from the bottom up.
struct ImpostorPictures {
    /// RGBA, colours times coverage: texture, appearance and whatever of the shading stays as it is.
    osg::ref_ptr<osg::Image> colors;
    /// RGBA, times coverage: normal in the tree's frame, from [-1, 1] to [0, 1]; 1 for leaves and 0 for bark.
    osg::ref_ptr<osg::Image> normals;
    int azimuths = 0, elevations = 0, pixels = 0;
    float halfWidth = 0.0f; ///< About the trunk's foot, metres.
    float height = 0.0f;    ///< Of the tree, metres.
    std::vector<glm::vec2>
        extents; ///< Per elevation: lowest and highest on the picture, metres from the foot.

    /// Share of a picture that stays empty at each side, so that none shows in its neighbour.
    static constexpr float margin = 1.0f / 16.0f;
    /// Levels of the images that keep them apart.
    int levels() const;
};

/// Paints without graphics; different threads may paint at once. Takes tens of milliseconds.
ImpostorPictures paintImpostor(const TreeModel& model, const Appearance& appearance,
                               const ImpostorSettings& settings = {});

} // namespace osgTreeWind
