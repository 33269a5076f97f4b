// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/Silhouette.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/species/Appearance.h>

namespace osgTreeWind {

/// How finely the crown of a tree is cut against the sky: along the lines of a picture, within its closed
/// outline.
struct LeafEdges {
    float edges = 0.0f;   ///< Changes between leaf and sky, over pixels.
    float leafRun = 0.0f; ///< Mean length of what is leaf between two of them, pixels,
    float skyRun = 0.0f;  ///< and of what is sky.
    float slope = 0.0f;   ///< Of the number of boxes that its edge meets, by their size from 1 to 16 pixels.
};

/// @param closing side of the square that closes the outline, pixels.
LeafEdges measureEdges(const Silhouette& picture, int closing);

/// A tree at rest as a camera sees it whose picture is 720 pixels high and 40 degrees, each of 2 x 2 samples,
/// at eye level from some distance of its foot, in metres.
class EdgePicture {
public:
    static constexpr int width = 960;
    static constexpr float pixelsPerMetreAt1m = 989.09f;

    EdgePicture(const TreeModel& model, const Appearance& appearance, float distance, float azimuth);

    /// Of cards, finely filtered. @param reductions times that the tree is reduced, TreeDetail::reduced(); 0:
    /// not.
    LeafEdges cards(int reductions) const;
    /// Of as many single leaves in the same places, each tilted as it is painted.
    LeafEdges singleLeaves() const;

    /// Where a point of the tree is, in samples, and how many a metre has there.
    glm::vec2 operator()(const glm::vec3& point) const;
    float samplesPerMetre(const glm::vec3& point) const;

private:
    LeafEdges measured(Silhouette& samples) const;

    const TreeModel& _model;
    const Appearance& _appearance;
    glm::vec3 _eye, _ahead, _right, _up;
    int _closing;
};

} // namespace osgTreeWind
