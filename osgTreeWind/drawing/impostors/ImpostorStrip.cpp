// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/impostors/ImpostorStrip.h>

#include <osgTreeWind/drawing/looks/PaintedTexture.h>
#include <osgTreeWind/drawing/looks/SceneGeometry.h>
#include <osgTreeWind/gpu/DistinctArrays.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/gpu/SharedObjects.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace osgTreeWind {
namespace {

osg::ref_ptr<osg::Geometry> makeStrip(int segments) {
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (int i = 0; i <= segments; ++i)
        for (const float s : {-1.0f, 1.0f})
            corners->push_back({s, static_cast<float>(i) / static_cast<float>(segments), 0.0f});
    osg::ref_ptr<osg::Geometry> geometry = new SceneGeometry;
    geometry->setName("impostor");
    geometry->setVertexArray(corners);
    std::vector<GLushort> indices(corners->size());
    std::iota(indices.begin(), indices.end(), GLushort(0));
    geometry->addPrimitiveSet(new osg::DrawElementsUShort(GL_TRIANGLE_STRIP, indices.begin(), indices.end()));
    makeArraysDistinct(*geometry);
    return geometry;
}

/// All impostors share one strip of each number of segments.
osg::ref_ptr<osg::Geometry> sharedStrip(int segments) {
    static SharedObjects<int, osg::Geometry> strips;
    return strips.get(segments, [&] { return makeStrip(segments); });
}

osg::ref_ptr<osg::Texture2D> texture(const char* name, osg::Image* image) {
    return makePaintedTexture(name, image, nullptr, osg::Texture::CLAMP_TO_EDGE);
}

osg::ref_ptr<osg::StateSet> stateSet(const ImpostorPictures& pictures, osg::Program* program) {
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(program, protectedProgram);
    state->setTextureAttribute(ImpostorStrip::colorUnit, texture("impostor colors", pictures.colors));
    state->setTextureAttribute(ImpostorStrip::normalUnit, texture("impostor normals", pictures.normals));
    state->addUniform(new osg::Uniform("impostorColors", ImpostorStrip::colorUnit));
    state->addUniform(new osg::Uniform("impostorNormals", ImpostorStrip::normalUnit));
    state->addUniform(new osg::Uniform("impostorSize", osg::Vec4(pictures.halfWidth, pictures.height,
                                                                 static_cast<float>(pictures.azimuths),
                                                                 static_cast<float>(pictures.elevations))));
    osg::ref_ptr<osg::Uniform> extents = new osg::Uniform(osg::Uniform::FLOAT_VEC2, "impostorExtents", 8);
    for (unsigned i = 0; i < 8; ++i) {
        const glm::vec2& extent = pictures.extents[std::min<std::size_t>(i, pictures.extents.size() - 1)];
        extents->setElement(i, osg::Vec2(extent.x, extent.y));
    }
    state->addUniform(extents);
    state->addUniform(new osg::Uniform("leafTint", osg::Vec3(1.0f, 1.0f, 1.0f)));
    drawBothSides(*state);
    return state;
}

} // namespace

ImpostorStrip::ImpostorStrip(ImpostorPictures pictures, osg::Program* program)
    : _pictures(std::move(pictures)), _coverage(_pictures), _geometry(sharedStrip(2)),
      _straight(sharedStrip(1)), _stateSet(osgTreeWind::stateSet(_pictures, program)) {
    _pictures.colors = _pictures.normals = nullptr; // the textures have them
}

} // namespace osgTreeWind
