// SPDX-License-Identifier: MIT
#include <tests/tool/portraits/LeafEdges.h>

#include <examples/osgtreewind/portraits/CrownDrawing.h>
#include <examples/osgtreewind/portraits/LeafMasks.h>
#include <osgTreeWind/drawing/instanced/TreeTiers.h>
#include <osgTreeWind/drawing/looks/LeafOutlines.h>
#include <osgTreeWind/drawing/looks/LeafSpray.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/TreeDetail.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

constexpr int samples = 2;
constexpr int outlineMask = 32;

/// Mask of a leaf within the rectangle around its outline.
struct BladeMask {
    Silhouette::Mask mask;
    glm::vec2 low{0.0f}, high{0.0f};

    explicit BladeMask(const LeafOutline& outline) {
        for (const glm::vec2& p : outline) {
            high = glm::max(high, p);
            low.y = glm::min(low.y, p.y);
        }
        low.x = -high.x;
        mask.size = outlineMask;
        for (int y = 0; y < outlineMask; ++y)
            for (int x = 0; x < outlineMask; ++x) {
                const glm::vec2 p = glm::mix(low, high, (glm::vec2(x, y) + 0.5f) / float{outlineMask});
                mask.solid.push_back(within(outline, {glm::abs(p.x), p.y}));
            }
    }

private:
    /// Even-odd test in the right half of the outline.
    static bool within(const LeafOutline& outline, const glm::vec2& p) {
        bool inside = false;
        for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
            const glm::vec2 &a = outline[i], &b = outline[i + 1];
            if ((a.y <= p.y) != (b.y <= p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
                inside = !inside;
        }
        return inside;
    }
};

} // namespace

LeafEdges measureEdges(const Silhouette& picture, int closing) {
    const int size = picture.size();
    const Silhouette outline = picture.outline(closing);
    std::size_t pixels = 0, changes = 0, runs[2] = {}, lengths[2] = {};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            if (!outline.black(x, y))
                continue;
            const bool leaf = picture.black(x, y), follows = x > 0 && outline.black(x - 1, y);
            const bool change = follows && picture.black(x - 1, y) != leaf;
            ++pixels;
            ++lengths[leaf];
            changes += change;
            runs[leaf] += change || !follows;
        }
    LeafEdges edges;
    if (pixels == 0)
        return edges;
    edges.edges = static_cast<float>(changes) / static_cast<float>(pixels);
    edges.skyRun = static_cast<float>(lengths[0]) / static_cast<float>(std::max<std::size_t>(runs[0], 1));
    edges.leafRun = static_cast<float>(lengths[1]) / static_cast<float>(std::max<std::size_t>(runs[1], 1));
    return edges;
}

float edgesOverSingleLeaves(const TreeModel& model, const Appearance& appearance, float distance) {
    const EdgePicture picture(model, appearance, distance, 0.3f);
    const float height = EdgePicture::pixelsPerMetreAt1m / distance * measureTree(model).height;
    const int tier = static_cast<int>(TreeTiers().choose(height).tier);
    return picture.cards(std::min(tier, TreeDetail::reductions)).edges / picture.singleLeaves().edges;
}

EdgePicture::EdgePicture(const TreeModel& model, const Appearance& appearance, float distance, float azimuth)
    : _model(model), _appearance(appearance) {
    glm::vec3 middle(0.0f), low(1e9f), high(-1e9f);
    for (const LeafCluster& leaf : model.leaves) {
        middle += leaf.anchor / static_cast<float>(model.leaves.size());
        low = glm::min(low, leaf.anchor);
        high = glm::max(high, leaf.anchor);
    }
    _eye = {distance * glm::cos(azimuth), distance * glm::sin(azimuth), 1.6f};
    _ahead = glm::normalize(glm::vec3(0, 0, middle.z) - _eye);
    _right = glm::normalize(glm::cross(_ahead, glm::vec3(0, 0, 1)));
    _up = glm::cross(_right, _ahead);
    const float across = high.x - low.x;
    _closing = std::max(static_cast<int>(across * pixelsPerMetreAt1m / distance / 12.0f), 2);
}

glm::vec2 EdgePicture::operator()(const glm::vec3& point) const {
    const glm::vec3 p = point - _eye;
    return 0.5f * samples * width + samplesPerMetre(point) * glm::vec2(glm::dot(p, _right), glm::dot(p, _up));
}

float EdgePicture::samplesPerMetre(const glm::vec3& point) const {
    return samples * pixelsPerMetreAt1m / glm::max(glm::dot(point - _eye, _ahead), 0.5f);
}

LeafEdges EdgePicture::measured(Silhouette& sampled) const {
    drawWood(
        _model.skeleton, *this, [&](const glm::vec3& p) { return samplesPerMetre(p); }, sampled);
    return measureEdges(sampled.shrunk(samples), _closing);
}

LeafEdges EdgePicture::cards(int reductions) const {
    const osg::ref_ptr<osg::Image> texture = leafImage(_appearance);
    Silhouette sampled(samples * width);
    const TreeDetail detail = TreeDetail::reduced(reductions);
    if (detail.bough == 1) {
        const LeafMasks masks(*texture);
        forEachLeafQuad(_model, [&](std::size_t cluster, std::size_t quad, const glm::vec3& corner,
                                    const glm::vec3& across, const glm::vec3& along) {
            const LeafAtlas::Choice choice = LeafAtlas::choose(cluster, quad);
            drawPiece(*this, corner, across, along, masks.leaves(choice.variant), sampled, choice.mirrored);
        });
        return measured(sampled);
    }
    const ThinnedLeaves thinned = thinnedLeaves(_model.leaves, _model.leafMesh, detail);
    TreeModel few;
    few.leaves = thinned.clusters;
    few.leafMesh = _model.leafMesh;
    const Silhouette::Mask masks[2] = {LeafMasks::maskOf(*texture, LeafAtlas::bough(thinned.bough, 0), 3),
                                       LeafMasks::maskOf(*texture, LeafAtlas::bough(thinned.bough, 1), 3)};
    forEachLeafQuad(few, [&](std::size_t cluster, std::size_t quad, const glm::vec3& corner,
                             const glm::vec3& across, const glm::vec3& along) {
        const LeafAtlas::Choice choice = LeafAtlas::choose(thinned.indices[cluster], 0);
        if (static_cast<int>(quad) == thinned.firstQuad(cluster))
            drawPiece(*this, corner, across, along, masks[choice.variant % 2], sampled, choice.mirrored);
    });
    return measured(sampled);
}

LeafEdges EdgePicture::singleLeaves() const {
    std::vector<LeafSpray> sprays;
    for (int i = 0; i < LeafAtlas::sprays; ++i)
        sprays.push_back(growSpray(_appearance.leafForm, i));
    const BladeMask blade(leafOutline(_appearance.leafForm));
    const LeafMasks cards(*leafImage(_appearance));
    Silhouette sampled(samples * width);
    forEachLeafQuad(_model, [&](std::size_t cluster, std::size_t quad, const glm::vec3& corner,
                                const glm::vec3& across, const glm::vec3& along) {
        const LeafAtlas::Choice choice = LeafAtlas::choose(cluster, quad);
        const glm::vec3 normal =
            glm::cross(across, along) / glm::sqrt(glm::length(across) * glm::length(along));
        const auto at = [&](const glm::vec3& p) {
            return corner + (choice.mirrored ? 1.0f - p.x : p.x) * across + p.y * along + p.z * normal;
        };
        for (const LeafBlade& leaf : sprays[static_cast<std::size_t>(choice.variant)].blades) {
            const glm::vec3 foot = at(leaf.point(blade.low)),
                            right = at(leaf.point({blade.high.x, blade.low.y})) - foot,
                            up = at(leaf.point({blade.low.x, blade.high.y})) - foot;
            drawPiece(*this, foot, right, up, blade.mask, sampled);
        }
        drawPiece(*this, corner, across, along, cards.twigs(choice.variant), sampled, choice.mirrored);
    });
    return measured(sampled);
}

} // namespace osgTreeWind
