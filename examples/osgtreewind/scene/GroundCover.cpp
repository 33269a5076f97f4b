// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/GroundCover.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace osgTreeWind;

/// Outline of a tree on the ground, metres.
struct Foot {
    osg::Vec2d place;
    double crown, trunk; ///< Radii.
    double shade;        ///< Share of the light that the crown absorbs.
};

/// Distance from the tree up to which fallen leaves lie, metres.
double reachOf(const Foot& foot) {
    return 1.8 * foot.crown + 1.5;
}

std::vector<Foot> feetOf(const Forest& forest) {
    const ForestSimulation& simulation = forest.getSimulation();
    std::vector<Foot> feet;
    for (const PlacedTree& tree : movingForest(simulation).trees())
        if (tree.alive) {
            const TreeSize size = movingForest(simulation).placed().sizeOf(tree);
            feet.push_back({{tree.position.x, tree.position.y},
                            0.5 * size.crownWidth,
                            0.5 * size.trunkDiameter,
                            0.35 + 0.5 * tree.leaves});
        }
    return feet;
}

/// Increases a channel of the texels around a place. @param covered share of the remaining light, by
/// distance.
template <typename Covered>
void paint(osg::Image& image, int channel, const osg::Vec2d& at, double radius, double cell,
           const Covered& covered) {
    const auto first = [&](double middle) { return std::max(static_cast<int>((middle - radius) / cell), 0); };
    const auto last = [&](double middle, int size) {
        return std::min(static_cast<int>((middle + radius) / cell) + 1, size - 1);
    };
    const int left = first(at.x()), right = last(at.x(), image.s());
    for (int y = first(at.y()); y <= last(at.y(), image.t()); ++y) {
        unsigned char* const row = image.data(0, y) + channel; // osg::Image::data() is slow per texel
        for (int x = left; x <= right; ++x) {
            const double away = (osg::Vec2d(cell * (x + 0.5), cell * (y + 0.5)) - at).length();
            unsigned char& texel = row[2 * x];
            texel = static_cast<unsigned char>(std::lround(255.0 - (255.0 - texel) * (1.0 - covered(away))));
        }
    }
}

} // namespace

GroundCover::GroundCover(const Forest& forest) {
    const std::vector<Foot> feet = feetOf(forest);
    if (feet.empty() || forest.getDescription().tiles)
        return;
    _low = feet.front().place;
    osg::Vec2d high = _low;
    for (const Foot& foot : feet)
        for (int axis = 0; axis < 2; ++axis) {
            const double reach = reachOf(foot) + 3.0;
            _low[axis] = std::min(_low[axis], foot.place[axis] - reach);
            high[axis] = std::max(high[axis], foot.place[axis] + reach);
        }
    const osg::Vec2d size = high - _low;
    _cell = std::max(std::max(size.x(), size.y()) / 1024.0, 0.1);
    _image = new osg::Image;
    _image->allocateImage(static_cast<int>(size.x() / _cell) + 2, static_cast<int>(size.y() / _cell) + 2, 1,
                          GL_RG, GL_UNSIGNED_BYTE);
    std::fill_n(_image->data(), _image->getTotalSizeInBytes(), static_cast<unsigned char>(0));
    for (const Foot& foot : feet) {
        const osg::Vec2d at = foot.place - _low;
        paint(*_image, 0, at, reachOf(foot), _cell, [&](double away) {
            const double part = std::clamp(away / reachOf(foot), 0.0, 1.0);
            return foot.shade * (1.0 - part * part) * (1.0 - part * part);
        });
        paint(*_image, 1, at, foot.trunk + 2.5, _cell, [&](double away) {
            const double beyond = std::max(away - foot.trunk, 0.0) / (0.2 + 1.5 * foot.trunk);
            return 0.5 * math::exp(-beyond);
        });
    }
    _texture = new osg::Texture2D(_image);
    _texture->setResizeNonPowerOfTwoHint(false);
    _texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    _texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_BORDER);
    _texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_BORDER);
    _texture->setBorderColor(osg::Vec4(0, 0, 0, 0));
}

float GroundCover::crownsOver(const osg::Vec2d& place) const {
    return channelAt(place, 0);
}

float GroundCover::trunkAt(const osg::Vec2d& place) const {
    return channelAt(place, 1);
}

float GroundCover::channelAt(const osg::Vec2d& place, int channel) const {
    const osg::Vec2d at = (place - _low) / _cell;
    if (isEmpty() || at.x() < 0.0 || at.y() < 0.0 || at.x() >= _image->s() || at.y() >= _image->t())
        return 0.0f;
    return static_cast<float>(_image->data(static_cast<int>(at.x()), static_cast<int>(at.y()))[channel]) /
           255.0f;
}

void GroundCover::setUniforms(osg::StateSet& state, unsigned unit) const {
    if (isEmpty())
        return;
    state.setTextureAttribute(unit, _texture);
    state.addUniform(new osg::Uniform("groundCover", static_cast<int>(unit)));
    state.addUniform(new osg::Uniform(
        "coverPlace",
        osg::Vec4(osg::Vec4d(_low.x(), _low.y(), 1.0 / (_cell * _image->s()), 1.0 / (_cell * _image->t())))));
}
