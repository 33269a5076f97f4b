// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/Setting.h>

#include <examples/osgtreewind/scene/Ground.h>
#include <examples/osgtreewind/scene/GroundShadows.h>
#include <examples/osgtreewind/scene/Sky.h>
#include <examples/osgtreewind/scene/SunShadows.h>
#include <examples/osgtreewind/scene/Tufts.h>

#include <osgTreeWind/forest/ForestDescription.h>

#include <osg/BlendFunc>
#include <osg/ColorMask>
#include <osg/Depth>
#include <osg/Fog>
#include <osg/LightModel>
#include <osg/LightSource>
#include <osg/Stencil>

namespace {

using osgTreeWind::Forest;

osg::ref_ptr<osg::LightSource> createSun(const Daylight& day) {
    osg::ref_ptr<osg::LightSource> sun = new osg::LightSource;
    sun->getLight()->setPosition(osg::Vec4(day.toSun, 0.0f));
    sun->getLight()->setAmbient(osg::Vec4(0.0f, 0.0f, 0.0f, 1.0f));
    sun->getLight()->setDiffuse(osg::Vec4(day.sun, 1.0f));
    return sun;
}

void lightBySky(osg::StateSet& state, const Daylight& day) {
    osg::ref_ptr<osg::LightModel> model = new osg::LightModel;
    model->setAmbientIntensity(osg::Vec4(day.sky + day.around, 1.0f));
    state.setAttribute(model);
    setGlow(state, day);
    setGroundLight(state, day);
    state.setDefine("FILM", "1.0");
}

/// Group that is drawn in the given render bin.
osg::ref_ptr<osg::Group> inBin(int bin, osg::Node* node) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->getOrCreateStateSet()->setRenderBinDetails(bin, "RenderBin");
    group->addChild(node);
    return group;
}

/// Draws things without sunlight, blended by 1 - alpha of the picture; alpha is 1 afterwards.
osg::ref_ptr<osg::Group> shaded(int bin, osg::Node* things) {
    osg::ref_ptr<osg::Group> group = inBin(bin, things);
    osg::StateSet* state = group->getStateSet();
    state->addUniform(sunOnGround(0.0f));
    state->setAttributeAndModes(new osg::BlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_DST_ALPHA, GL_ONE, GL_ZERO));
    state->setAttribute(new osg::ColorMask(true, true, true, true));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
    osg::ref_ptr<osg::Stencil> stencil = new osg::Stencil; // skips pixels outside the shadows
    stencil->setFunction(osg::Stencil::EQUAL, shadowStencil, ~0u);
    state->setAttributeAndModes(stencil);
    return group;
}

} // namespace

osg::ref_ptr<osg::Group> createSetting(Forest& forest, const SettingOptions& options) {
    const Daylight& day = options.day;
    osg::ref_ptr<osg::LightSource> sun = createSun(day);
    const bool isOfTiles = forest.getDescription().tiles.has_value(); // soft shadows need trees that stay
    const Shadows shadows = options.shadows == Shadows::Soft && isOfTiles ? Shadows::Off : options.shadows;
    osg::ref_ptr<osg::Group> setting = shadows == Shadows::On
                                           ? osg::ref_ptr<osg::Group>(new SunShadows(&forest, day.toSun))
                                           : osg::ref_ptr<osg::Group>(new osg::Group);
    // Alpha of the picture is reserved for the shadows.
    osg::StateSet* state = setting->getOrCreateStateSet();
    state->setAttribute(new osg::ColorMask(true, true, true, false));
    lightBySky(*state, day);
    osg::ref_ptr<osg::Fog> haze = new osg::Fog;
    haze->setMode(osg::Fog::EXP2);
    haze->setColor(osg::Vec4(day.haze, 1.0f));
    haze->setDensity(2.2f / groundRadius(forest.getBound()));
    state->setAttributeAndModes(haze);

    osg::ref_ptr<osg::Group> around = new osg::Group, lawn = new osg::Group;
    around->getOrCreateStateSet()->setDefine("FOG_MODE", "3");
    if (shadows == Shadows::On) {
        SunShadows::setDefines(*around->getStateSet());
        around->getStateSet()->setDefine("SHADOW_CLEARANCE", "0.0");
    }
    const GroundCover cover(forest);
    const osg::ref_ptr<osg::Node> ground = createGround(forest, cover);
    lawn->addChild(ground);
    around->addChild(inBin(-4, ground));
    if (options.eye) {
        const osg::ref_ptr<osg::Geometry> tufts = createTufts(forest, cover, *options.eye);
        lawn->addChild(tufts);
        around->addChild(inBin(-2, tufts)); // after the shadows on the ground
    }
    if (shadows == Shadows::Soft) {
        around->addChild(inBin(-3, createGroundShadows(forest, day.toSun, *setting)));
        around->addChild(shaded(-1, lawn));
    }
    around->addChild(createSky(day));
    setting->addChild(around);
    setting->addChild(sun);
    setting->addChild(&forest);
    return setting;
}
