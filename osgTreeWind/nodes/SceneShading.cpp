// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/SceneShading.h>

#include <osg/Fog>
#include <osg/Uniform>

#include <string>

namespace osgTreeWind {
namespace {

constexpr unsigned firm = osg::StateAttribute::OVERRIDE, guarded = osg::StateAttribute::PROTECTED;

/// The state sets above a place, nearest first.
class Above {
public:
    explicit Above(const osgUtil::StateGraph* place) : _place(place) {}

    /// A mode as OSG would apply it; nothing where nobody says.
    osg::StateAttribute::GLModeValue mode(osg::StateAttribute::GLMode mode) const {
        osg::StateAttribute::GLModeValue result = osg::StateAttribute::INHERIT;
        any([&](const osg::StateSet& set) {
            const auto value = set.getMode(mode);
            if (value != osg::StateAttribute::INHERIT && !(result & guarded) &&
                (result == osg::StateAttribute::INHERIT || (value & firm)))
                result = value;
            return false;
        });
        return result;
    }

    const osg::Fog* fog() const {
        const osg::Fog* fog = nullptr;
        any([&](const osg::StateSet& set) {
            fog = dynamic_cast<const osg::Fog*>(set.getAttribute(osg::StateAttribute::FOG));
            return fog != nullptr;
        });
        return fog;
    }

    /// The value of an integer uniform or sampler; negative where there is none.
    int number(const std::string& name) const {
        int value = -1;
        any([&](const osg::StateSet& set) {
            const osg::Uniform* uniform = set.getUniform(name);
            if (uniform)
                uniform->get(value);
            return uniform != nullptr;
        });
        return value;
    }

private:
    /// Asks one after another until one says true.
    template <typename Question>
    void any(const Question& question) const {
        for (const osgUtil::StateGraph* place = _place; place; place = place->_parent)
            if (place->getStateSet() && question(*place->getStateSet()))
                return;
    }

    const osgUtil::StateGraph* _place;
};

bool isOn(osg::StateAttribute::GLModeValue value) {
    return value != osg::StateAttribute::INHERIT && (value & osg::StateAttribute::ON);
}

int fogMode(const osg::Fog* fog) {
    if (!fog)
        return 2; // OpenGL's default is exponential
    return fog->getMode() == osg::Fog::LINEAR ? 1 : fog->getMode() == osg::Fog::EXP ? 2 : 3;
}

const std::string oneMap = "osgShadow_shadowTexture", firstMap = "shadowTexture0",
                  secondMap = "shadowTexture1";

enum { Lights, Unlit, Fog, OneMap, FirstMap, SecondMap };

osg::ref_ptr<osg::StateSet> stateOf(const std::array<int, 6>& scene) {
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    const auto define = [&](const char* name, int value) { state->setDefine(name, std::to_string(value)); };
    if (scene[Lights] != 0)
        define("LIGHT_MASK", scene[Lights]);
    if (scene[Unlit] != 0)
        define("UNLIT", 1);
    if (scene[Fog] != 0)
        define("FOG_MODE", scene[Fog]);
    if (scene[OneMap] >= 0)
        define("SHADOW_MAP", scene[OneMap]);
    if (scene[FirstMap] >= 0) {
        define("SHADOW_MAPS", scene[SecondMap] < 0 ? 1 : 2);
        define("SHADOW_MAP_UNIT0", scene[FirstMap]);
        if (scene[SecondMap] >= 0)
            define("SHADOW_MAP_UNIT1", scene[SecondMap]);
    }
    return state;
}

} // namespace

osg::ref_ptr<osg::StateSet> SceneShading::stateFor(const osgUtil::CullVisitor& visitor) {
    const Above above(const_cast<osgUtil::CullVisitor&>(visitor).getCurrentStateGraph());
    std::array<int, 6> scene{};
    for (int i = 0; i < 8; ++i)
        if (isOn(above.mode(GL_LIGHT0 + static_cast<unsigned>(i))))
            scene[Lights] |= 1 << i;
    const auto lighting = above.mode(GL_LIGHTING);
    scene[Unlit] = lighting != osg::StateAttribute::INHERIT && !isOn(lighting);
    if (isOn(above.mode(GL_FOG)))
        scene[Fog] = fogMode(above.fog());
    scene[OneMap] = above.number(oneMap);
    scene[FirstMap] = above.number(firstMap);
    scene[SecondMap] = above.number(secondMap);

    const std::lock_guard<std::mutex> lock(_mutex);
    osg::ref_ptr<osg::StateSet>& state = _states[scene];
    if (!state)
        state = stateOf(scene);
    return state;
}

} // namespace osgTreeWind
