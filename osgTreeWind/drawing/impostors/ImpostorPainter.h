// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/species/Species.h>

#include <osg/Image>

#include <glm/vec2.hpp>

#include <vector>

namespace osgTreeWind {

/// View directions and resolution of the pictures of an impostor. Ranges are not checked.
struct ImpostorSettings {
    int azimuths = 8;    ///< Number of azimuths, evenly around the tree, [4, 32].
    int elevations = 4;  ///< Number of elevations, evenly from the horizon to the zenith, [2, 8].
    int pixels = 64;     ///< Width and height of a picture, a power of two, [32, 512].
    int samples = 2;     ///< Rows and columns of samples in a pixel, [1, 4].
    float leaves = 1.0f; ///< Share of the leaves that the tree bears, [0, 1].
};

/// Pictures of one tree at rest, as a grid in two images: azimuths from left to right, counter-clockwise from
/// +x; elevations from the bottom up.
struct ImpostorPictures {
    /// RGBA, premultiplied by coverage: albedo, and the shading that does not depend on the lights.
    osg::ref_ptr<osg::Image> colors;
    /// RGBA, premultiplied by coverage. RGB: LightLobe::gradient in the tree's frame, encoded in [0, 1]. A: 1
    /// for leaves, 0 for bark.
    osg::ref_ptr<osg::Image> normals;
    int azimuths = 0, elevations = 0, pixels = 0;
    float halfWidth = 0.0f; ///< Half the width of a picture around the trunk, without margins, metres.
    float height = 0.0f;    ///< Of the tree, metres.
    std::vector<glm::vec2> extents; ///< By elevation: bottom and top of a picture, metres from the foot.

    /// Empty share of a picture at each side, against bleeding between neighbouring pictures.
    static constexpr float margin = 1.0f / 16.0f;
    /// Number of mipmap levels at which the margin separates pictures.
    int levels() const;
};

/// Paints the pictures of a tree on the CPU. Takes tens of milliseconds. Threads may paint at the same time.
ImpostorPictures paintImpostor(const TreeModel& model, const Appearance& appearance,
                               const ImpostorSettings& settings = {});

} // namespace osgTreeWind
