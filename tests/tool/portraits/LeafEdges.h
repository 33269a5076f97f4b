// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/portraits/Silhouette.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/species/Appearance.h>

namespace osgTreeWind {

/// Fineness of the edges between leaves and sky, along the rows of a picture within the closed outline of the
/// crown.
struct LeafEdges {
    float edges = 0.0f;   ///< Changes between leaf and sky per pixel.
    float leafRun = 0.0f; ///< Mean length of a run of leaf, pixels.
    float skyRun = 0.0f;  ///< Mean length of a run of sky, pixels.
};

/// Measures a picture. @param closing side of the square that closes the outline, pixels.
LeafEdges measureEdges(const Silhouette& picture, int closing);

/// Edges of a tree at a distance in metres, as drawn there, divided by those of the tree with single leaves.
float edgesOverSingleLeaves(const TreeModel& model, const Appearance& appearance, float distance);

/// A tree at rest, seen from eye level at a distance in metres by a camera with a picture of 720 pixels and
/// 40 degrees in height, with 2 x 2 samples per pixel.
class EdgePicture {
public:
    static constexpr int width = 960;
    static constexpr float pixelsPerMetreAt1m = 989.09f;

    EdgePicture(const TreeModel& model, const Appearance& appearance, float distance, float azimuth);

    /// Edges of the tree drawn with leaf cards. @param reductions how many times detail is reduced
    /// (TreeDetail::reduced()).
    LeafEdges cards(int reductions) const;
    /// Edges of the tree with single leaves in the places where leaves are painted on the cards.
    LeafEdges singleLeaves() const;

    /// Position of a point of the tree in the picture, in samples.
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
