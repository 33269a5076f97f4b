// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/Tufts.h>

#include <examples/osgtreewind/scene/DefaultView.h>
#include <examples/osgtreewind/scene/Ground.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/ValueNoise.h>
#include <osgTreeWind/drawing/looks/SceneGeometry.h>
#include <osgTreeWind/species/Season.h>
#include <osgTreeWind/wind/Wind.h>

#include <osg/Image>
#include <osg/Texture2D>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace math = osgTreeWind::math;

namespace {

using osgTreeWind::Random;

constexpr double farthestTuft = 40.0, tuftSpacing = 0.34; // metres

/// Adds plants to the vertex arrays.
class Plants {
public:
    Plants(osg::Vec3Array& corners, osg::Vec3Array& coords) : _corners(corners), _coords(coords) {}

    /// Begins a plant. @param nearness 1 at the eye, 0 at the largest distance.
    void begin(const osg::Vec3& foot, float nearness) { _foot = foot, _nearness = nearness; }

    /// @param vigour factor on the height.
    void addBlade(Random& random, float vigour) {
        const float angle = 6.2832f * random.uniform(), lean = 0.2f + 0.6f * random.uniform();
        const float height = vigour * (0.10f + 0.18f * random.uniform()) * std::sqrt(_nearness);
        const float width =
            0.004f + 0.02f * (1.0f - _nearness); // wider in the distance, to cover some pixels
        const osg::Vec3 way(math::cos(angle), math::sin(angle), 0.0f),
            side(-way.y() * width, way.x() * width, 0.0f);
        const osg::Vec3 foot = _foot + way * (0.07f * random.uniform());
        const float own = random.uniform();
        add(foot - side, 0.0f, own, height);
        add(foot + side, 0.0f, own, height);
        add(foot + way * (lean * height) + osg::Vec3(0, 0, height), 1.0f, own, height);
    }

    /// A herb: a tuft of leaves that bend outward, the lower the longer.
    void addHerb(Random& random) {
        const float height = 0.06f + 0.16f * random.uniform();
        const int leaves = 6 + static_cast<int>(8.0f * random.uniform());
        for (int leaf = 0; leaf < leaves; ++leaf) {
            const float up = random.uniform();
            addLeaf(_foot + osg::Vec3(0, 0, 0.6f * up * height), 6.2832f * random.uniform(),
                    height * (0.9f - 0.5f * up), 0.2f + 0.7f * up, height, random);
        }
    }

    /// A sapling: a thin stem with leafy shoots.
    void addSapling(Random& random) {
        const float height = 0.4f + 1.1f * random.uniform() * random.uniform();
        const osg::Vec3 top(0.2f * height * (random.uniform() - 0.5f),
                            0.2f * height * (random.uniform() - 0.5f), height);
        addStem(_foot, _foot + top, 0.006f, height);
        const int shoots = 4 + static_cast<int>(8.0f * height), leaves = 6;
        for (int shoot = 0; shoot < shoots; ++shoot) {
            const float rise = 0.3f + 0.7f * static_cast<float>(shoot) / static_cast<float>(shoots);
            const float angle = 2.4f * static_cast<float>(shoot) + random.uniform();
            const osg::Vec3 from = _foot + top * rise, way(math::cos(angle), math::sin(angle), 0.5f);
            const float length = height * (1.2f - rise) * (0.25f + 0.2f * random.uniform());
            addStem(from, from + way * length, 0.003f, height);
            for (int leaf = 1; leaf <= leaves; ++leaf)
                addLeaf(from + way * (length * static_cast<float>(leaf) / leaves),
                        angle + (leaf % 2 ? 0.9f : -0.9f), 0.05f + 0.04f * random.uniform(),
                        0.3f * random.uniform(), height, random);
        }
    }

private:
    void add(const osg::Vec3& corner, float rise, float own, float height) {
        _corners.push_back(corner);
        _coords.push_back({rise, own, height});
    }
    void addStem(const osg::Vec3& from, const osg::Vec3& to, float width, float height) {
        const osg::Vec3 side(width, width, 0.0f);
        for (const osg::Vec3& corner : {from - side, from + side, to})
            add(corner, (corner.z() - _foot.z()) / height, 0.0f, height);
    }
    /// A pointed leaf. @param steepness rise over length. @param height of the plant, which sways.
    void addLeaf(const osg::Vec3& foot, float angle, float length, float steepness, float height,
                 Random& random) {
        const osg::Vec3 way(math::cos(angle), math::sin(angle), steepness),
            side = osg::Vec3(-math::sin(angle), math::cos(angle), 0.3f * random.uniform()) * (0.28f * length);
        const osg::Vec3 widest = foot + way * (0.55f * length),
                        tip = foot + (way - osg::Vec3(0, 0, 0.4f)) * length;
        const float own = 1.0f + 0.99f * random.uniform(), rise = (foot.z() - _foot.z()) / height;
        for (const float hand : {-1.0f, 1.0f}) {
            add(foot, 0.6f * rise, own, height);
            add(widest + side * hand, 0.4f + 0.6f * rise, own, height);
            add(tip, 0.4f + 0.6f * rise, own, height);
        }
    }

    osg::Vec3Array& _corners;
    osg::Vec3Array& _coords;
    osg::Vec3 _foot;
    float _nearness = 0.0f;
};

/// Noise in [0, 1] over the ground, in patches of some metres.
float patchAt(const osg::Vec2d& place, double size, std::uint32_t seed) {
    return osgTreeWind::valueNoise(
        {static_cast<float>(place.x() / size), static_cast<float>(place.y() / size)}, glm::ivec2(1 << 20),
        seed);
}

/// Writes the wind over the tufts into a texture in each frame.
class TuftWind : public osg::DrawableUpdateCallback {
public:
    TuftWind(const osgTreeWind::Forest& forest, const osg::Vec3d& eye) : _forest(&forest), _eye(eye) {
        _image->allocateImage(across, across, 1, GL_RGB, GL_FLOAT);
        _image->setInternalTextureFormat(GL_RGB32F_ARB);
        _image->setDataVariance(osg::Object::DYNAMIC);
        const auto at = [](double middle, int cell) {
            return static_cast<float>(middle + farthestTuft * ((2.0 * cell + 1.0) / across - 1.0));
        };
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < across; ++i) {
                const float x = at(eye.x(), i), y = at(eye.y(), j);
                const auto ground = static_cast<float>(groundHeight(forest, {x, y}, 0.0));
                _places.emplace_back(glm::vec3(x, y, ground + 1.0f), ground);
            }
    }

    void setUniforms(osg::StateSet& state) const {
        constexpr int unit = 4;
        osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(_image);
        texture->setDataVariance(osg::Object::DYNAMIC);
        texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
        texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
        texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
        state.setTextureAttribute(unit, texture);
        state.addUniform(new osg::Uniform("tuftWind", unit));
        state.addUniform(
            new osg::Uniform("tuftWindPlace", osg::Vec3(static_cast<float>(_eye.x() - farthestTuft),
                                                        static_cast<float>(_eye.y() - farthestTuft),
                                                        static_cast<float>(0.5 / farthestTuft))));
    }

    void update(osg::NodeVisitor* visitor, osg::Drawable*) override {
        const osg::FrameStamp* stamp = visitor->getFrameStamp();
        if (!stamp || stamp->getFrameNumber() == _frame)
            return;
        _frame = stamp->getFrameNumber();
        auto* winds = reinterpret_cast<glm::vec3*>(_image->data());
        if (const osgTreeWind::WindFieldPtr field = osgTreeWind::asField(_forest->getWind()))
            field->sample(_places.data(), _places.size(), stamp->getSimulationTime(), winds);
        else
            std::fill_n(winds, _places.size(), glm::vec3(0.0f));
        _image->dirty();
    }

private:
    static constexpr int across = 16;

    osg::ref_ptr<const osgTreeWind::Forest> _forest;
    osg::Vec3d _eye;
    /// One metre above the ground; west to east, then south to north.
    std::vector<osgTreeWind::WindPlace> _places;
    osg::ref_ptr<osg::Image> _image = new osg::Image;
    unsigned _frame = ~0u;
};

} // namespace

osg::ref_ptr<osg::Geometry> createTufts(const osgTreeWind::Forest& forest, const GroundCover& cover,
                                        const osg::Vec3d& eye) {
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec3Array> coords = new osg::Vec3Array;
    Plants plants(*corners, *coords);
    const float leafy = 1.0f - 0.9f * std::min(std::abs(forest.getSeason() - osgTreeWind::midsummer) / 2.0f,
                                               1.0f); // in winter, few herbs
    const auto cellOf = [](double place) {
        return static_cast<std::int64_t>(std::floor(place / tuftSpacing));
    };
    for (std::int64_t j = cellOf(eye.y() - farthestTuft); j <= cellOf(eye.y() + farthestTuft); ++j)
        for (std::int64_t i = cellOf(eye.x() - farthestTuft); i <= cellOf(eye.x() + farthestTuft); ++i) {
            Random random(static_cast<std::uint32_t>(i * 73856093 ^ j * 19349663));
            osg::Vec2d place(static_cast<double>(i), static_cast<double>(j));
            for (int axis = 0; axis < 2; ++axis)
                place[axis] = tuftSpacing * (place[axis] + random.uniform());
            const double away = (place - osg::Vec2d(eye.x(), eye.y())).length() / farthestTuft;
            const auto nearness = static_cast<float>(std::max(1.0 - away, 0.0));
            const float crowns = cover.crownsOver(place), trunk = cover.trunkAt(place),
                        thick = patchAt(place, 2.3, 41);
            plants.begin(osg::Vec3(osg::Vec3d(place, groundHeight(forest, place, 0.0))), nearness);
            const auto grows = [&](float share) { return random.uniform() < nearness * nearness * share; };
            // Grass in the open and around trunks; herbs where some light reaches; saplings in gaps and at
            // edges.
            if (grows(std::max(1.0f - 0.9f * crowns, std::min(5.0f * trunk - 0.5f, 1.0f))))
                for (int blade = 4 + static_cast<int>(9.0f * thick); blade > 0; --blade)
                    plants.addBlade(random, 0.6f + 0.8f * thick);
            const float light = 4.0f * crowns * (1.0f - crowns), herbs = patchAt(place, 3.1, 42);
            if (grows(leafy * light * std::max(1.2f * herbs - 0.4f, trunk)))
                plants.addHerb(random);
            if (grows(leafy * 0.06f * light * std::max(4.0f * patchAt(place, 5.0, 43) - 2.4f, 0.0f)))
                plants.addSapling(random);
        }
    osg::ref_ptr<osg::Geometry> tufts = new osgTreeWind::SceneGeometry;
    tufts->setVertexArray(corners);
    tufts->setTexCoordArray(0, coords);
    tufts->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<int>(corners->size())));
    tufts->setStateSet(createGrassState(forest, cover, "#define TUFTS\n"));
    const osg::ref_ptr<TuftWind> wind = new TuftWind(forest, eye);
    wind->setUniforms(*tufts->getStateSet());
    tufts->setUpdateCallback(wind);
    return tufts;
}
