// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/Tufts.h>

#include <examples/osgtreewind/scene/DefaultView.h>
#include <examples/osgtreewind/scene/Ground.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/drawing/looks/SceneGeometry.h>
#include <osgTreeWind/wind/Wind.h>

#include <osg/Image>
#include <osg/Texture2D>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace {

constexpr double farthestTuft = 40.0, tuftSpacing = 0.34; // metres

/// Adds the blades of a tuft to the vertex arrays.
class Tuft {
public:
    /// @param nearness 1 at the eye, 0 at the largest distance.
    Tuft(osg::Vec3Array& corners, osg::Vec3Array& coords, const osg::Vec3& foot, float nearness)
        : _corners(corners), _coords(coords), _foot(foot), _nearness(nearness) {}

    void add(osgTreeWind::Random& random) {
        const float angle = 6.2832f * random.uniform(), lean = 0.2f + 0.6f * random.uniform();
        const float height = (0.10f + 0.18f * random.uniform()) * std::sqrt(_nearness);
        const float width =
            0.004f + 0.02f * (1.0f - _nearness); // wider in the distance, to cover some pixels
        const osg::Vec3 way(std::cos(angle), std::sin(angle), 0.0f),
            side(-way.y() * width, way.x() * width, 0.0f);
        const osg::Vec3 foot = _foot + way * (0.07f * random.uniform());
        const float own = random.uniform();
        for (const auto& [corner, rise] :
             {std::pair(foot - side, 0.0f), std::pair(foot + side, 0.0f),
              std::pair(foot + way * (lean * height) + osg::Vec3(0, 0, height), 1.0f)}) {
            _corners.push_back(corner);
            _coords.push_back({rise, own, height});
        }
    }

private:
    osg::Vec3Array& _corners;
    osg::Vec3Array& _coords;
    osg::Vec3 _foot;
    float _nearness;
};

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
    const auto cellOf = [](double place) {
        return static_cast<std::int64_t>(std::floor(place / tuftSpacing));
    };
    for (std::int64_t j = cellOf(eye.y() - farthestTuft); j <= cellOf(eye.y() + farthestTuft); ++j)
        for (std::int64_t i = cellOf(eye.x() - farthestTuft); i <= cellOf(eye.x() + farthestTuft); ++i) {
            osgTreeWind::Random random(static_cast<std::uint32_t>(i * 73856093 ^ j * 19349663));
            osg::Vec2d place(static_cast<double>(i), static_cast<double>(j));
            for (int axis = 0; axis < 2; ++axis)
                place[axis] = tuftSpacing * (place[axis] + random.uniform());
            const double away = (place - osg::Vec2d(eye.x(), eye.y())).length() / farthestTuft;
            const auto nearness = static_cast<float>(1.0 - away);
            if (random.uniform() >= nearness * nearness * (1.0f - 0.9f * cover.crownsOver(place)))
                continue;
            Tuft tuft(*corners, *coords, osg::Vec3(osg::Vec3d(place, groundHeight(forest, place, 0.0))),
                      nearness);
            for (int blade = 0; blade < 8; ++blade)
                tuft.add(random);
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
