// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/SunShadows.h>

#include <osgTreeWind/base/PortableMath.h>

#include <osg/ColorMask>
#include <osg/PolygonOffset>
#include <osg/Texture2D>

#include <osgUtil/CullVisitor>

#include <cmath>

namespace math = osgTreeWind::math;

namespace {

constexpr int shadowTexels = 4096; // width and height of a shadow map

osg::ref_ptr<osg::Texture2D> depthTexture() {
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(shadowTexels, shadowTexels);
    texture->setInternalFormat(GL_DEPTH_COMPONENT);
    texture->setShadowComparison(true);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_BORDER);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_BORDER);
    texture->setBorderColor(osg::Vec4(1, 1, 1, 1)); // everything outside the map is lit
    return texture;
}

/// Smallest sphere around the view of a camera up to a distance.
osg::BoundingSphered sphereOf(const osg::CullStack& view, double reach) {
    const osg::Matrixd& projection = *view.getProjectionMatrix();
    const double wide = (1.0 + std::abs(projection(2, 0))) / projection(0, 0),
                 high = (1.0 + std::abs(projection(2, 1))) / projection(1, 1);
    const double side = wide * wide + high * high; // squared half diagonal of the view at distance 1
    const double along = std::min(0.5 * (1.0 + side), 1.0);
    const osg::Vec3d middle(0.0, 0.0, -along * reach);
    const double radius = reach * math::hypot(1.0 - along, std::sqrt(side));
    return {middle * osg::Matrixd::inverse(*view.getModelViewMatrix()), radius};
}

} // namespace

SunShadows::SunShadows(osg::Node* casters, const osg::Vec3& toSun) : _casters(casters), _toSun(toSun) {
    _toSun.normalize();
    constexpr double reaches[] = {120.0, 2500.0};
    _isSmall = casters->getBound().radius() < 0.5 * reaches[0]; // the least radius of sphereOf()
    osg::ref_ptr<osg::Texture2D> texture;
    for (std::size_t i = _maps.size(); i-- > 0;) {
        Map& map = _maps[i];
        map.reach = reaches[i];
        const int unit = firstUnit + static_cast<int>(i);
        if (!texture || !_isSmall)
            texture = depthTexture(); // 64 MB
        map.camera->setName("sun shadows");
        map.camera->setReferenceFrame(osg::Camera::ABSOLUTE_RF);
        map.camera->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
        map.camera->setRenderOrder(osg::Camera::PRE_RENDER);
        map.camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        map.camera->setViewport(0, 0, shadowTexels, shadowTexels);
        map.camera->setClearMask(GL_DEPTH_BUFFER_BIT);
        map.camera->attach(osg::Camera::DEPTH_BUFFER, texture);
        map.camera->setImplicitBufferAttachmentMask(0, 0); // no colours, which take 64 MB
        map.camera->addChild(casters);
        osg::StateSet* state = map.camera->getOrCreateStateSet();
        constexpr auto overriding = osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE;
        state->setAttribute(new osg::ColorMask(false, false, false, false), overriding);
        state->setAttributeAndModes(new osg::PolygonOffset(1.1f, 4.0f), overriding);

        map.planes->setMode(osg::TexGen::EYE_LINEAR);
        getOrCreateStateSet()->setTextureAttribute(unit, texture);
        getOrCreateStateSet()->addUniform(
            new osg::Uniform(("shadowTexture" + std::to_string(i)).c_str(), unit));
    }
}

void SunShadows::setDefines(osg::StateSet& state) {
    state.setDefine("SHADOW_MAPS", "2");
    state.setDefine("SHADOW_MAP_UNIT0", std::to_string(firstUnit));
    state.setDefine("SHADOW_MAP_UNIT1", std::to_string(firstUnit + 1));
}

bool SunShadows::follow(Map& map, const osg::CullStack& view) const {
    const osg::BoundingSphere all = _casters->getBound();
    osg::BoundingSphered seen = sphereOf(view, map.reach);
    const bool holdsAll = all.radius() < seen.radius();
    if (holdsAll)
        seen.set(all.center(), all.radius());
    osg::Camera& camera = *map.camera;
    camera.setViewMatrixAsLookAt(all.center() + _toSun, all.center(),
                                 std::abs(_toSun.z()) < 0.99 ? osg::Z_AXIS : osg::Y_AXIS);
    const double texel = 2.0 * seen.radius() / shadowTexels;
    const osg::Vec3d middle = seen.center() * camera.getViewMatrix();
    const double x = texel *
                     std::round(middle.x() / texel), // whole texels keep edges still when the eye moves
        y = texel * std::round(middle.y() / texel);
    camera.setProjectionMatrixAsOrtho(x - seen.radius(), x + seen.radius(), y - seen.radius(),
                                      y + seen.radius(), 1.0 - all.radius(), 1.0 + all.radius());
    map.planes->setPlanesFromMatrix(camera.getViewMatrix() * camera.getProjectionMatrix() *
                                    osg::Matrixd::translate(1.0, 1.0, 1.0) *
                                    osg::Matrixd::scale(0.5, 0.5, 0.5));
    return holdsAll;
}

void SunShadows::traverse(osg::NodeVisitor& visitor) {
    if (auto* cull = visitor.asCullVisitor(); cull && _casters->getBound().valid())
        for (std::size_t i = 0; i < _maps.size(); ++i) {
            const bool holdsAll = follow(_maps[i], *cull);
            // The next map is the same: everything is outside this one.
            if ((holdsAll || _isSmall) && i + 1 < _maps.size())
                _maps[i].planes->setPlanesFromMatrix(osg::Matrixd::scale(0.0, 0.0, 0.0) *
                                                     osg::Matrixd::translate(2.0, 2.0, 2.0));
            else
                _maps[i].camera->accept(visitor);
            cull->getRenderStage()->addPositionedTextureAttribute(
                firstUnit + static_cast<unsigned>(i), cull->getModelViewMatrix(), _maps[i].planes);
        }
    osg::Group::traverse(visitor);
}

void SunShadows::releaseGLObjects(osg::State* state) const {
    osg::Group::releaseGLObjects(state);
    for (const Map& map : _maps)
        map.camera->releaseGLObjects(state);
}
