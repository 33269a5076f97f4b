// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/Setting.h>

#include <examples/osgtreewind/scene/Ground.h>
#include <examples/osgtreewind/scene/Sky.h>
#include <examples/osgtreewind/scene/SunShadows.h>
#include <examples/osgtreewind/scene/Tufts.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/gpu/OpenGLProfile.h>

#include <osg/Fog>
#include <osg/LightModel>
#include <osg/LightSource>

#include <algorithm>

namespace {

using osgTreeWind::CompatibilityOnly, osgTreeWind::Forest, osgTreeWind::numberText;

osg::ref_ptr<osg::LightSource> createSun(const Daylight& day) {
    osg::ref_ptr<osg::LightSource> sun = new osg::LightSource;
    sun->setLight(new CompatibilityOnly<osg::Light>);
    sun->getLight()->setPosition(osg::Vec4(day.toSun, 0.0f));
    sun->getLight()->setAmbient(osg::Vec4(0.0f, 0.0f, 0.0f, 1.0f));
    sun->getLight()->setDiffuse(osg::Vec4(day.sun, 1.0f));
    return sun;
}

void lightBySky(osg::StateSet& state, const Daylight& day) {
    osg::ref_ptr<osg::LightModel> model = new CompatibilityOnly<osg::LightModel>;
    model->setAmbientIntensity(osg::Vec4(day.sky + day.around, 1.0f));
    state.setAttribute(model);
    setGlow(state, day);
    setGroundLight(state, day);
}

/// Exposure of the film: as in daylight, but up to three times as long in a closed wood.
double exposureAt(const osg::Vec3d& eye, const Forest& forest, const GroundCover& cover) {
    if (eye.z() > forest.getBound().center().z())
        return 1.0;
    double covered = 0.0; // mean of 25 places
    for (int i = 0; i < 25; ++i)
        covered += static_cast<double>(
                       cover.crownsOver({eye.x() + 6.0 * (i % 5 - 2), eye.y() + 6.0 * (i / 5 - 2)})) /
                   25.0;
    return 1.0 + 2.0 * std::max(2.0 * covered - 1.0, 0.0);
}

} // namespace

osg::ref_ptr<osg::Group> createSetting(Forest& forest, const SettingOptions& options) {
    const Daylight& day = options.day;
    const bool shadows = options.shadows.value_or(!forest.getDescription().tiles);
    osg::ref_ptr<osg::Group> setting = shadows ? new SunShadows(&forest, day.toSun) : new osg::Group;
    osg::StateSet* state = setting->getOrCreateStateSet();
    lightBySky(*state, day);
    const GroundCover cover(forest);
    state->setDefine("FILM", numberText(options.eye ? exposureAt(*options.eye, forest, cover) : 1.0));
    osg::ref_ptr<osg::Fog> haze = new CompatibilityOnly<osg::Fog>;
    haze->setMode(osg::Fog::EXP2);
    haze->setColor(osg::Vec4(day.haze, 1.0f));
    haze->setDensity(2.2f / groundRadius(forest.getBound()));
    state->setAttributeAndModes(haze);

    osg::ref_ptr<osg::Group> around = new osg::Group, lawn = new osg::Group;
    around->getOrCreateStateSet()->setDefine("FOG_MODE", "3");
    if (shadows) {
        SunShadows::setDefines(*around->getStateSet());
        around->getStateSet()->setDefine("SHADOW_CLEARANCE", "0.0");
    }
    lawn->getOrCreateStateSet()->setRenderBinDetails(-1, "RenderBin");
    lawn->addChild(createGround(forest, cover));
    if (options.eye)
        lawn->addChild(createTufts(forest, cover, *options.eye));
    around->addChild(lawn);
    around->addChild(createSky(day));
    setting->addChild(around);
    setting->addChild(createSun(day));
    setting->addChild(&forest);
    return setting;
}
