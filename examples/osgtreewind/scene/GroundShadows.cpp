// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/GroundShadows.h>

#include <examples/osgtreewind/scene/LeafMasks.h>
#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/gpu/DataTexture.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/modal/ModalLean.h>

#include <osg/BlendEquation>
#include <osg/ColorMask>
#include <osg/Depth>
#include <osg/Program>
#include <osg/Stencil>
#include <osg/Texture2DArray>
#include <osg/observer_ptr>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace {

using namespace osgTreeWind;

constexpr int silhouettePixels = 128, samplesPerPixel = 2; // of a silhouette, in each direction

// gl_MultiTexCoord1: number of the tree; height, as a share of the tree's, that casts this part of the
// shadow.
const char* shadowVertexText = R"(
uniform sampler2D treeLeans; // xy: lean of the top, metres; z: whether the tree has fallen
out vec3 spot;
void main() {
    spot = gl_MultiTexCoord0.xyz;
    vec4 place = gl_Vertex;
    vec4 lean = dataTexel(treeLeans, int(gl_MultiTexCoord1.x + 0.5));
    place.xy += pow(gl_MultiTexCoord1.y, LEAN_POWER) * lean.xy;
#ifdef RELIEF
    vec4 eye = gl_ModelViewMatrix * place;
    eye.xyz *= 1.0 - 0.004 - min(0.3 / length(eye.xyz), 0.5); // in front of the ground at every level of detail
    gl_Position = gl_ProjectionMatrix * eye;
#else
    gl_Position = gl_ModelViewProjectionMatrix * place;
#endif
    gl_Position *= 1.0 - lean.z;
})";

const char* shadowFragmentText = R"(#version 330 compatibility
in vec3 spot;
uniform sampler2DArray silhouettes;
void main() {
    vec2 size = 128.0 * fwidth(spot.xy);
    float lod = max(log2(max(size.x, size.y)), 0.5 + 2.0 * spot.y); // penumbra
    float shade = textureLod(silhouettes, spot, lod).r;
    if (shade < 0.004)
        discard;
    gl_FragColor = vec4(0.0, 0.0, 0.0, 1.0 - 0.9 * shade); // crowns let some light through
})";

/// Projection along the sunlight to level ground, in the frame of a tree.
struct ShadowProjection {
    glm::vec2 across, away;
    float slope; ///< Metres away from the sun per metre of height.

    glm::vec2 operator()(const glm::vec3& p) const {
        return {glm::dot(glm::vec2(p), across), glm::dot(glm::vec2(p), away) + slope * p.z};
    }
};

/// Shadow of a shape, and its position on the ground relative to the foot of an unscaled tree.
struct ShadowPicture {
    glm::vec2 low{0.0f}, high{1e-3f};
    osg::ref_ptr<osg::Image> image = new osg::Image;

    ShadowPicture(const TreeModel& model, const Appearance& appearance, float leaves,
                  const ShadowProjection& project) {
        const auto quads = [&](auto use) {
            for (std::size_t i = 0; i < model.leaves.size(); ++i)
                for (std::size_t v = 0; v < model.leafMesh.size(); v += 4) {
                    const LeafCluster& leaf = model.leaves[i];
                    const auto at = [&](std::size_t corner) {
                        return project(leaf.anchor +
                                       leaf.size * (leaf.orientation * model.leafMesh[v + corner].corner));
                    };
                    use(isClusterBorne(i, leaves), at(0), at(1) - at(0), at(3) - at(0));
                }
        };
        const auto cover = [&](const glm::vec2& p) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        };
        quads([&](bool, const glm::vec2& corner, const glm::vec2& across, const glm::vec2& along) {
            for (const glm::vec2& p : {corner, corner + across, corner + along, corner + across + along})
                cover(p);
        });
        for (std::size_t unit = 0; unit < model.skeleton.units.size(); ++unit)
            cover(project(model.skeleton.point(unit, model.skeleton.ringsPerBranch - 1)));
        const glm::vec2 margin = 0.06f * (high - low);
        low -= margin;
        high += margin;

        const glm::vec2 scale = static_cast<float>(samplesPerPixel * silhouettePixels) / (high - low);
        const osg::ref_ptr<osg::Image> card = leafImage(appearance);
        const Silhouette::Mask leafy = LeafMasks::maskOf(*card, LeafAtlas::spray(0), 3),
                               bare = LeafMasks::maskOf(*card, LeafAtlas::spray(0), 2), solid{1, {1}};
        Silhouette black(samplesPerPixel * silhouettePixels);
        quads([&](bool borne, const glm::vec2& corner, const glm::vec2& across, const glm::vec2& along) {
            black.draw(scale * (corner - low), scale * across, scale * along, borne ? leafy : bare);
        });
        for (std::size_t unit = 0; unit < model.skeleton.units.size(); ++unit)
            for (int ring = 0; ring + 1 < model.skeleton.ringsPerBranch; ++ring) {
                const glm::vec2 start = project(model.skeleton.point(unit, ring)),
                                along = project(model.skeleton.point(unit, ring + 1)) - start;
                const glm::vec2 side = model.skeleton.radius(unit, ring) * glm::vec2(along.y, -along.x) /
                                       glm::max(glm::length(along), 1e-6f);
                black.draw(scale * (start - side - low), scale * (2.0f * side), scale * along, solid);
            }
        image->allocateImage(silhouettePixels, silhouettePixels, 1, GL_RED, GL_UNSIGNED_BYTE);
        image->setInternalTextureFormat(GL_R8);
        for (int y = 0; y < silhouettePixels; ++y)
            for (int x = 0; x < silhouettePixels; ++x) {
                int count = 0;
                for (int i = 0; i < samplesPerPixel * samplesPerPixel; ++i)
                    count += black.black(samplesPerPixel * x + i % samplesPerPixel,
                                         samplesPerPixel * y + i / samplesPerPixel);
                *image->data(x, y) =
                    static_cast<unsigned char>(255 * count / (samplesPerPixel * samplesPerPixel));
            }
    }
};

osg::ref_ptr<osg::StateSet> stateOf(const std::vector<ShadowPicture>& pictures, bool isRelief,
                                    const DataTexture& leans) {
    osg::ref_ptr<osg::Texture2DArray> texture = new osg::Texture2DArray;
    texture->setTextureSize(silhouettePixels, silhouettePixels, static_cast<int>(pictures.size()));
    texture->setInternalFormat(GL_R8);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    for (std::size_t i = 0; i < pictures.size(); ++i)
        texture->setImage(static_cast<unsigned>(i), pictures[i].image);
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX, std::string("#version 330 compatibility\n") +
                                                                (isRelief ? "#define RELIEF\n" : "") +
                                                                "#define LEAN_POWER " +
                                                                std::to_string(leanPower) + '\n' +
                                                                shaderText("data.glsl") + shadowVertexText));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, shadowFragmentText));
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(program);
    state->setTextureAttribute(0, texture);
    state->addUniform(new osg::Uniform("silhouettes", 0));
    bindDataTexture(*state, "treeLeans", 1, leans.texture());
    state->setAttributeAndModes(
        new osg::BlendEquation(osg::BlendEquation::RGBA_MIN)); // shadows do not add up
    osg::ref_ptr<osg::Stencil> stencil = new osg::Stencil;
    stencil->setFunction(osg::Stencil::ALWAYS, shadowStencil, ~0u);
    stencil->setOperation(osg::Stencil::KEEP, osg::Stencil::KEEP, osg::Stencil::REPLACE);
    state->setAttributeAndModes(stencil);
    state->setAttribute(new osg::ColorMask(false, false, false, true));
    state->setAttributeAndModes(
        new osg::Depth(isRelief ? osg::Depth::LEQUAL : osg::Depth::ALWAYS, 0.0, 1.0, false));
    return state;
}

/// Moves points of a shadow from level ground at the foot of a tree to the forest's ground.
class GroundProjection {
public:
    GroundProjection(const Forest& forest, const glm::vec2& away, float slope)
        : _ground(forest.getDescription().ground), _origin(forest.getDescription().origin),
          _run(slope * away) {}

    bool isRelief() const { return _ground != nullptr; }
    /// @param farthest largest height difference of the ground, metres.
    osg::Vec3 operator()(const glm::vec2& level, float height, float farthest) const {
        constexpr int steps = 8;
        float drop = 0.0f;
        for (int i = 0; _ground && i < steps; ++i) {
            const glm::vec2 at = level + drop * _run;
            const auto ground = _ground->height(glm::dvec2(_origin) + glm::dvec2(at));
            const float below = ground ? height - static_cast<float>(*ground - _origin.z) : drop;
            drop = glm::clamp(drop + 0.7f * (below - drop), -farthest, farthest);
        }
        const glm::vec2 at = level + drop * _run;
        return {at.x, at.y, height - drop};
    }

private:
    osgTreeWind::GroundPtr _ground;
    glm::dvec3 _origin;
    glm::vec2 _run; ///< Horizontal displacement per metre of descent.
};

/// Triangles of the unit square, divided into columns and rows.
std::vector<glm::vec2> squares(int columns, int rows) {
    std::vector<glm::vec2> corners;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            for (const glm::vec2& spot : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 0),
                                          glm::vec2(1, 1), glm::vec2(0, 1)})
                corners.push_back((glm::vec2(x, y) + spot) / glm::vec2(columns, rows));
    return corners;
}

/// Passes the lean of the trees to the shader after they have moved.
class LeanUpdate : public osg::NodeCallback {
public:
    LeanUpdate(const Forest& forest, DataTexture leans)
        : _forest(&forest), _leans(std::move(leans)),
          _count(movingForest(forest.getSimulation()).trees().size()) {}

    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override {
        traverse(node, visitor);
        osg::ref_ptr<const Forest> forest;
        if (!_forest.lock(forest))
            return;
        const ModalMotion* modal = movingForest(forest->getSimulation()).modal();
        const std::size_t trees = modal ? movingForest(forest->getSimulation()).trees().size() : 0;
        for (std::size_t i = 0; i < std::min(trees, _count); ++i) { // trees added later have no shadow
            const glm::vec2 lean = modal->lean(i);
            _leans.data()[4 * i] = lean.x;
            _leans.data()[4 * i + 1] = lean.y;
            const TreeFall* fall = modal->fall(i);
            _leans.data()[4 * i + 2] = fall && fall->isDown ? 1.0f : 0.0f;
        }
        _leans.dirty();
    }

private:
    osg::observer_ptr<const Forest> _forest;
    DataTexture _leans;
    std::size_t _count; ///< Number of trees with a shadow.
};

} // namespace

osg::ref_ptr<osg::Geometry> createGroundShadows(const Forest& forest, const osg::Vec3& sun,
                                                osg::Node& above) {
    const ForestSimulation& simulation = forest.getSimulation();
    const glm::vec2 level(sun.x(), sun.y());
    const glm::vec2 away = glm::length(level) > 1e-3f ? -glm::normalize(level) : glm::vec2(1.0f, 0.0f);
    const glm::vec2 across(-away.y, away.x);
    const auto turned = [](const glm::vec2& v, float by) {
        return glm::vec2(glm::cos(by) * v.x - glm::sin(by) * v.y, glm::sin(by) * v.x + glm::cos(by) * v.y);
    };
    const float run = glm::length(level) / glm::max(sun.z(), 0.035f); // metres of shadow per metre of height
    const GroundProjection toGround(forest, away, run);
    const auto trees = static_cast<float>(movingForest(simulation).trees().size());
    const int fine = static_cast<int>(glm::clamp(std::sqrt(2e5f / trees), 1.0f, 6.0f));
    const std::vector<glm::vec2> spotsOfOne = squares(toGround.isRelief() ? fine : 1, fine);
    std::map<std::uint32_t, std::size_t> pictureOf; // by model, drawn for its first tree
    std::vector<ShadowPicture> pictures;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array, spots = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec2Array> parts = new osg::Vec2Array;
    for (std::size_t i = 0; i < movingForest(simulation).trees().size(); ++i) {
        const PlacedTree& tree = movingForest(simulation).trees()[i];
        if (!tree.alive)
            continue;
        const auto [found, first] = pictureOf.emplace(tree.model, pictures.size());
        if (first) {
            const ShadowProjection projection{turned(across, -tree.heading), turned(away, -tree.heading),
                                              run * tree.scale.axes.z / tree.scale.axes.x};
            pictures.emplace_back(*movingForest(simulation).models()[tree.model],
                                  simulation.description().species[tree.species].appearance, tree.leaves,
                                  projection);
        }
        const ShadowPicture& picture = pictures[found->second];
        const float length = run * movingForest(simulation).placed().sizeOf(tree).height,
                    half = 0.5f * tree.scale.axes.x * (picture.high.x - picture.low.x);
        const float lying = length * length / (length * length + half * half);
        for (const glm::vec2& spot : spotsOfOne) {
            const glm::vec2 place = tree.scale.axes.x * glm::mix(picture.low, picture.high, spot);
            const glm::vec2 at = glm::vec2(tree.position) + place.x * across + place.y * away;
            corners->push_back(
                toGround(at, tree.position.z + 0.02f, tree.scale.axes.x * (picture.high.y - picture.low.y)));
            spots->push_back({spot.x, spot.y, static_cast<float>(found->second)});
            const float share =
                glm::mix(0.75f, place.y / glm::max(length, 1e-3f), lying); // as in impostor.vert
            parts->push_back({static_cast<float>(i), glm::clamp(share, 0.0f, 1.0f)});
        }
    }
    osg::ref_ptr<osg::Geometry> shadows = new osg::Geometry;
    shadows->setUseDisplayList(false);
    shadows->setUseVertexBufferObjects(true);
    shadows->setVertexArray(corners);
    shadows->setTexCoordArray(0, spots);
    shadows->setTexCoordArray(1, parts);
    shadows->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<int>(corners->size())));
    const DataTexture leans("tree leans", movingForest(simulation).trees().size());
    shadows->setStateSet(stateOf(pictures, toGround.isRelief(), leans));
    above.addUpdateCallback(new LeanUpdate(forest, leans));
    return shadows;
}
