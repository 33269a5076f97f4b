// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/SceneShading.h>

#include <osg/Fog>
#include <osg/Uniform>

#include <vector>

namespace osgTreeWind {
namespace {

constexpr unsigned firm = osg::StateAttribute::OVERRIDE, guarded = osg::StateAttribute::PROTECTED;

/// The state sets above a place, nearest first.
class Above {
public:
    explicit Above(const osgUtil::StateGraph* place) {
        for (; place; place = place->_parent)
            if (place->getStateSet())
                _sets.push_back(place->getStateSet());
    }

    /// A mode as OSG would apply it; nothing where nobody says.
    osg::StateAttribute::GLModeValue mode(osg::StateAttribute::GLMode mode) const {
        osg::StateAttribute::GLModeValue result = osg::StateAttribute::INHERIT;
        for (const osg::StateSet* set : _sets) {
            const auto value = set->getMode(mode);
            if (value == osg::StateAttribute::INHERIT || (result & guarded))
                continue;
            if (result == osg::StateAttribute::INHERIT || (value & firm))
                result = value;
        }
        return result;
    }

    const osg::Fog* fog() const {
        for (const osg::StateSet* set : _sets)
            if (const auto* fog = dynamic_cast<const osg::Fog*>(set->getAttribute(osg::StateAttribute::FOG)))
                return fog;
        return nullptr;
    }

    /// The value of an integer uniform or sampler as text; empty where there is none.
    std::string number(const char* name) const {
        int value = 0;
        for (const osg::StateSet* set : _sets)
            if (const osg::Uniform* uniform = set->getUniform(name))
                return uniform->get(value) ? std::to_string(value) : std::string();
        return {};
    }

private:
    std::vector<const osg::StateSet*> _sets;
};

bool isOn(osg::StateAttribute::GLModeValue value) {
    return value != osg::StateAttribute::INHERIT && (value & osg::StateAttribute::ON);
}

std::string fogMode(const osg::Fog* fog) {
    if (!fog)
        return "2"; // OpenGL's default is exponential
    return fog->getMode() == osg::Fog::LINEAR ? "1" : fog->getMode() == osg::Fog::EXP ? "2" : "3";
}

} // namespace

osg::ref_ptr<osg::StateSet> SceneShading::stateFor(const osgUtil::CullVisitor& visitor) {
    const Above above(const_cast<osgUtil::CullVisitor&>(visitor).getCurrentStateGraph());
    std::map<std::string, std::string> defines;
    unsigned lights = 0;
    for (unsigned i = 0; i < 8; ++i)
        if (isOn(above.mode(GL_LIGHT0 + i)))
            lights |= 1u << i;
    if (lights != 0)
        defines["LIGHT_MASK"] = std::to_string(lights);
    const auto lighting = above.mode(GL_LIGHTING);
    if (lighting != osg::StateAttribute::INHERIT && !isOn(lighting))
        defines["UNLIT"] = "1";
    if (isOn(above.mode(GL_FOG)))
        defines["FOG_MODE"] = fogMode(above.fog());
    const std::string shadowMap = above.number("osgShadow_shadowTexture");
    const std::string first = above.number("shadowTexture0"), second = above.number("shadowTexture1");
    if (!shadowMap.empty())
        defines["SHADOW_MAP"] = shadowMap;
    if (!first.empty()) {
        defines["SHADOW_MAPS"] = second.empty() ? "1" : "2";
        defines["SHADOW_MAP_UNIT0"] = first;
        defines["SHADOW_MAP_UNIT1"] = second;
    }

    const std::lock_guard<std::mutex> lock(_mutex);
    osg::ref_ptr<osg::StateSet>& state = _states[defines];
    if (!state) {
        state = new osg::StateSet;
        for (const auto& [name, value] : defines)
            if (!value.empty())
                state->setDefine(name, value);
    }
    return state;
}

} // namespace osgTreeWind
