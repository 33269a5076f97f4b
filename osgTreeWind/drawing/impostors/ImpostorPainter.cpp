// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/impostors/ImpostorPainter.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/drawing/impostors/LeafPieces.h>
#include <osgTreeWind/drawing/impostors/LightLobe.h>
#include <osgTreeWind/drawing/looks/BarkRelief.h>
#include <osgTreeWind/drawing/looks/ByteOf.h>
#include <osgTreeWind/drawing/looks/LeafStencils.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/model/CrownShade.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>

namespace osgTreeWind {
namespace {

osg::ref_ptr<osg::Image> blankImage(int width, int height) {
    osg::Image::MipmapDataType offsets;
    unsigned bytes = 0;
    for (int w = width, h = height;; w = std::max(w / 2, 1), h = std::max(h / 2, 1)) {
        bytes += static_cast<unsigned>(4 * w * h);
        if (w == 1 && h == 1)
            break;
        offsets.push_back(bytes);
    }
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setImage(width, height, 1, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, new unsigned char[bytes](),
                    osg::Image::USE_NEW_DELETE);
    image->setMipmapLevels(offsets);
    return image;
}

unsigned char* texels(osg::Image& image, int level) {
    return level ? image.getMipmapData(static_cast<unsigned>(level)) : image.data();
}

void halve(osg::Image& image, int level) {
    const unsigned char* from = texels(image, level - 1);
    unsigned char* to = texels(image, level);
    const int width = image.s() >> level, height = image.t() >> level, row = 8 * width;
    for (int y = 0; y < height; ++y)
        for (int i = 0; i < 4 * width; ++i) {
            const unsigned char* at = from + 2 * row * y + 8 * (i / 4) + i % 4;
            const int half = 1 + ((i / 4 + y) & 1); // rounds up as often as down, for values of few steps
            *to++ = static_cast<unsigned char>((at[0] + at[4] + at[row] + at[row + 4] + half) / 4);
        }
}

/// Mean colours of young and of old bark in shaders/bark_texture.glsl.
struct MeanBark {
    glm::vec3 young{0.0f}, old{0.0f};

    explicit MeanBark(const Appearance& appearance) {
        const osg::ref_ptr<osg::Image> image = barkImage(appearance);
        const int texels = image->s() * image->t();
        for (int i = 0; i < texels; ++i) {
            const unsigned char* texel = image->data() + 4 * i;
            young += Laws().texelTint(texel[3] / 255.0f, texel[2] / 255.0f);
            old += Laws().texelTint(texel[0] / 255.0f, texel[2] / 255.0f);
        }
        young *= appearance.bark / static_cast<float>(texels);
        old *= appearance.oldBarkColor() / static_cast<float>(texels);
    }
};

/// A straight piece of a branch.
struct BarkPiece {
    glm::vec3 start, end;
    float radius;
    glm::vec3 color;
    CrownShade::Light light;
};

std::vector<BarkPiece> barkPieces(const Skeleton& skeleton, const CrownShade& crown,
                                  const Appearance& appearance) {
    const MeanBark bark(appearance);
    const glm::vec3 ageing = barkAgeing(appearance.barkForm);
    std::vector<BarkPiece> pieces;
    const int last = skeleton.ringsPerBranch - 1, count = glm::min(last, 5);
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit)
        for (int i = 0; i < count; ++i) {
            const int from = i * last / count, to = (i + 1) * last / count;
            const glm::vec3 start = skeleton.point(unit, from);
            const float radius = 0.5f * (skeleton.radius(unit, from) + skeleton.radius(unit, to));
            const glm::vec3 stem = glm::mix(bark.young, bark.old, Laws().barkAge(radius, start.z, ageing));
            pieces.push_back({start, skeleton.point(unit, to), radius,
                              glm::mix(appearance.twigColor(), stem, Laws().stemShare(radius)),
                              crown.at(start)});
        }
    return pieces;
}

class Painter {
public:
    Painter(const TreeModel& model, const Appearance& appearance, const ImpostorSettings& settings)
        : _settings(settings),
          _crown(model.leaves, model.leafMesh,
                 leafCoverage(appearance.leafForm) * Laws().shadingArea(settings.leaves)),
          _leaves(leafPieces(thinnedLeaves(model.leaves, model.leafMesh, TreeDetail::full()), model.leafMesh,
                             _crown, appearance, settings.leaves)),
          _bark(barkPieces(model.skeleton, _crown, appearance)),
          _stencils(LeafStencils::ofAtlas(leafImage(appearance))),
          _raster(settings.pixels * settings.samples), _leafRasterizer(_leaves, *_stencils),
          _fronts(_bark.size()) {
        for (const LeafPiece& leaf : _leaves)
            _lobes.emplace_back(leaf.light, leaf.normal, true);
        _solid.fill(1);
        measure();
    }

    ImpostorPictures pictures() {
        for (int row = 0; row < _settings.elevations; ++row)
            for (int column = 0; column < _settings.azimuths; ++column) {
                draw(row, column);
                resolve(row, column);
            }
        for (int level = 1; level < _pictures.levels(); ++level)
            for (osg::Image* image : {_pictures.colors.get(), _pictures.normals.get()})
                halve(*image, level);
        return _pictures;
    }

private:
    float elevation(int row) const {
        return glm::half_pi<float>() * static_cast<float>(row) / static_cast<float>(_settings.elevations - 1);
    }

    /// Computes bounds for all view directions.
    void measure() {
        _pictures.azimuths = _settings.azimuths;
        _pictures.elevations = _settings.elevations;
        _pictures.pixels = _settings.pixels;
        for (osg::ref_ptr<osg::Image>* image : {&_pictures.colors, &_pictures.normals})
            *image =
                blankImage(_settings.azimuths * _settings.pixels, _settings.elevations * _settings.pixels);
        _pictures.halfWidth = _pictures.height = 1e-3f;
        _pictures.extents.assign(static_cast<std::size_t>(_settings.elevations), glm::vec2(0.0f, 1e-3f));
        for (const BarkPiece& piece : _bark)
            expandBounds(piece.end, piece.radius);
        for (const LeafPiece& piece : _leaves)
            for (const float across : {0.0f, 1.0f})
                for (const float along : {0.0f, 1.0f})
                    expandBounds(piece.corner + across * piece.across + along * piece.along, 0.0f);
    }
    void expandBounds(const glm::vec3& p, float reach) {
        const float away = glm::length(glm::vec2(p));
        _pictures.halfWidth = glm::max(_pictures.halfWidth, away + reach);
        _pictures.height = glm::max(_pictures.height, p.z + reach);
        for (int row = 0; row < _settings.elevations; ++row) {
            glm::vec2& extent = _pictures.extents[static_cast<std::size_t>(row)];
            const float rise = math::cos(elevation(row)) * p.z,
                        shift = math::sin(elevation(row)) * away + reach;
            extent = {glm::min(extent.x, rise - shift), glm::max(extent.y, rise + shift)};
        }
    }

    /// Size of a pixel of the largest level in its finer direction, metres.
    float pixelSize() const {
        constexpr float sharper = 1.05f; // matches llvmpipe, which chooses finer mipmaps than the formula
        const glm::vec2 extent = _pictures.extents.front();
        return glm::min(2.0f * _pictures.halfWidth, extent.y - extent.x) /
               (sharper * static_cast<float>(_settings.pixels) * (1.0f - 2.0f * ImpostorPictures::margin));
    }

    void draw(int row, int column) {
        const TreeView view(glm::two_pi<float>() * static_cast<float>(column) /
                                static_cast<float>(_settings.azimuths),
                            elevation(row));
        const glm::vec2 extent = _pictures.extents[static_cast<std::size_t>(row)];
        const float inner = static_cast<float>(_raster.size()) * (1.0f - 2.0f * ImpostorPictures::margin);
        const glm::vec3 scale{0.5f * inner / _pictures.halfWidth, inner / (extent.y - extent.x), 1.0f};
        const glm::vec3 shift{
            0.5f * static_cast<float>(_raster.size()),
            static_cast<float>(_raster.size()) * ImpostorPictures::margin - scale.y * extent.x, 0.0f};
        _raster.clear();
        _leafRasterizer.draw(view, scale, shift, pixelSize(), _raster);
        for (std::size_t i = 0; i < _bark.size(); ++i) {
            const BarkPiece& piece = _bark[i];
            const glm::vec3 start = view(piece.start), along = view(piece.end) - start;
            const float length = glm::length(glm::vec2(along));
            if (length < 1e-6f)
                continue;
            const glm::vec3 side = glm::vec3(along.y, -along.x, 0.0f) / length;
            const glm::vec3 front = glm::normalize(glm::cross(side, along));
            _fronts[i] = {side.x * view.right + side.y * view.up,
                          front.x * view.right + front.y * view.up + front.z * view.toEye};
            const glm::vec3 corner = start - piece.radius * side + glm::vec3(0, 0, 0.7f * piece.radius);
            _raster.draw({scale * corner + shift, scale * (2.0f * piece.radius * side), scale * along},
                         _solid, static_cast<std::uint32_t>(_leaves.size() + i));
        }
    }

    void resolve(int row, int column) {
        const int n = _settings.samples;
        const float weight = 1.0f / static_cast<float>(n * n);
        const auto left = static_cast<unsigned>(column * _settings.pixels);
        for (int y = 0; y < _settings.pixels; ++y) {
            const auto t = static_cast<unsigned>(row * _settings.pixels + y);
            unsigned char* colors = _pictures.colors->data(left, t); // osg::Image::data() is slow per texel
            unsigned char* normals = _pictures.normals->data(left, t);
            for (int x = 0; x < _settings.pixels; ++x, colors += 4, normals += 4) {
                Sum sum;
                for (int i = 0; i < n * n; ++i)
                    add(_raster.sample(n * x + i % n, n * y + i / n), sum);
                if (sum.color.a == 0.0f)
                    continue;
                const glm::vec4 color = weight * sum.color,
                                normal = weight * sum.color.a / sum.strength * sum.light;
                for (int c = 0; c < 4; ++c) {
                    colors[c] = byteOf(color[c]);
                    normals[c] = byteOf(normal[c]);
                }
            }
        }
    }

    struct Sum {
        glm::vec4 color{0.0f}; ///< Lit albedo; number of samples.
        glm::vec4 light{0.0f}; ///< Encoded gradient and share of leaves, weighted by strength.
        float strength = 0.0f;
        void add(const glm::vec3& albedo, const LightLobe& lobe, float leaf) {
            color += glm::vec4(lobe.strength * albedo, 1.0f);
            light += lobe.strength * glm::vec4(0.5f + 0.5f / LightLobe::maxGradient * lobe.gradient, leaf);
            strength += lobe.strength;
        }
    };

    void add(const TreeRaster::Sample& sample, Sum& sum) const {
        if (sample.item == TreeRaster::nothing)
            return;
        if (sample.item < _leaves.size()) {
            const LeafPiece& leaf = _leaves[sample.item];
            const glm::vec3 tint = leaf.borne ? _leafRasterizer.tint(sample) : glm::vec3(1.0f);
            sum.add(tint * leaf.color, _lobes[sample.item], 1.0f);
            return;
        }
        const std::size_t piece = sample.item - _leaves.size();
        const Front& front = _fronts[piece];
        const float side =
            2.0f * (static_cast<float>(sample.cell % TreeRaster::cells) + 0.5f) / TreeRaster::cells - 1.0f;
        const glm::vec3 outward = side * front.side + glm::sqrt(1.0f - side * side) * front.front;
        sum.add(_bark[piece].color, LightLobe(_bark[piece].light, outward, false), 0.0f);
    }

    /// Axes of a bark piece in the current view: unit vectors to its right and toward the eye, tree's frame.
    struct Front {
        glm::vec3 side, front;
    };

    ImpostorSettings _settings;
    CrownShade _crown;
    std::vector<LeafPiece> _leaves;
    std::vector<LightLobe> _lobes; ///< Of the leaves.
    std::vector<BarkPiece> _bark;
    LeafStencils::Atlas _stencils;
    TreeRaster::Stencil _solid;
    TreeRaster _raster;
    LeafRasterizer _leafRasterizer;
    std::vector<Front> _fronts;
    ImpostorPictures _pictures;
};

} // namespace

int ImpostorPictures::levels() const {
    constexpr int least = 2; // down to 8 pixels, with a margin of half a pixel
    return static_cast<int>(math::log2(static_cast<double>(pixels))) - least;
}

ImpostorPictures paintImpostor(const TreeModel& model, const Appearance& appearance,
                               const ImpostorSettings& settings) {
    return Painter(model, appearance, settings).pictures();
}

} // namespace osgTreeWind
