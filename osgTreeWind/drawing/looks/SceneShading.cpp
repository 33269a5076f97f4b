// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/SceneShading.h>

#include <osg/Fog>
#include <osg/GLExtensions>
#include <osg/Multisample>
#include <osg/Uniform>

#include <algorithm>
#include <string>
#include <vector>

namespace osgTreeWind {
namespace {

constexpr unsigned firm = osg::StateAttribute::OVERRIDE, guarded = osg::StateAttribute::PROTECTED;

/// The state sets above a place, that of the scene's root first.
class Above {
public:
    explicit Above(const osgUtil::StateGraph* place) {
        for (; place; place = place->_parent)
            if (place->getStateSet())
                _sets.push_back(place->getStateSet());
        std::reverse(_sets.begin(), _sets.end());
    }

    /// A mode as OSG applies it; nothing where nobody says.
    osg::StateAttribute::GLModeValue mode(osg::StateAttribute::GLMode mode) const {
        osg::StateAttribute::GLModeValue result = osg::StateAttribute::INHERIT;
        for (const osg::StateSet* set : _sets)
            take(result, set->getMode(mode));
        return result;
    }

    const osg::Fog* fog() const {
        const osg::StateAttribute* result = nullptr;
        osg::StateAttribute::OverrideValue former = 0;
        for (const osg::StateSet* set : _sets)
            if (const auto* fog = set->getAttributePair(osg::StateAttribute::FOG))
                if (take(former, fog->second))
                    result = fog->first;
        return static_cast<const osg::Fog*>(result);
    }

    /// The value of an integer uniform or sampler as text; empty where there is none.
    std::string number(const char* name) const {
        int value = 0;
        for (auto set = _sets.rbegin(); set != _sets.rend(); ++set)
            if (const osg::Uniform* uniform = (*set)->getUniform(name))
                return uniform->get(value) ? std::to_string(value) : std::string();
        return {};
    }

private:
    /// Whether the value of a state set further down comes through.
    static bool take(unsigned& above, unsigned below) {
        const bool through = below != osg::StateAttribute::INHERIT && (!(above & firm) || (below & guarded));
        if (through)
            above = below;
        return through;
    }

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

void setSceneDefines(osg::StateSet& state, const osgUtil::StateGraph* place, bool samples) {
    const Above above(place);
    osg::StateSet::DefineList defines;
    const auto define = [&](const char* name, const std::string& value) {
        defines[name] = {value, osg::StateAttribute::ON};
    };
    std::string lights;
    for (unsigned i = 0; i < 8; ++i)
        if (isOn(above.mode(GL_LIGHT0 + i)))
            lights += (lights.empty() ? "" : ", ") + std::to_string(i);
    if (!lights.empty())
        define("LIGHTS", lights);
    const auto lighting = above.mode(GL_LIGHTING);
    if (lighting != osg::StateAttribute::INHERIT && !isOn(lighting))
        define("UNLIT", "1");
    if (isOn(above.mode(GL_FOG)))
        define("FOG_MODE", fogMode(above.fog()));
    if (isOn(above.mode(GL_FRAMEBUFFER_SRGB)))
        define("LINEAR_COLORS", "1");
    const auto multisample = above.mode(GL_MULTISAMPLE_ARB);
    if (samples && (multisample == osg::StateAttribute::INHERIT || isOn(multisample)))
        define("COVERAGE", "1");
    const std::string shadowMap = above.number("osgShadow_shadowTexture");
    if (!shadowMap.empty())
        define("SHADOW_MAP", shadowMap);
    const std::string first = above.number("shadowTexture0"), second = above.number("shadowTexture1");
    if (!first.empty()) {
        define("SHADOW_MAPS", second.empty() ? "1" : "2");
        define("SHADOW_MAP_UNIT0", first);
        if (!second.empty())
            define("SHADOW_MAP_UNIT1", second);
    }
    state.setDefineList(defines);
}

bool choosesSamples(const osg::Camera& camera, const osg::State& state) {
    if (!osg::isGLExtensionOrVersionSupported(state.getContextID(), "GL_ARB_sample_shading", 4.0f))
        return false;
    if (camera.getRenderTargetImplementation() == osg::Camera::FRAME_BUFFER_OBJECT) {
        const auto& attachments = camera.getBufferAttachmentMap();
        return std::any_of(attachments.begin(), attachments.end(),
                           [](const auto& each) { return each.second._multisampleSamples > 1; });
    }
    GLint buffers = 0;
    glGetIntegerv(GL_SAMPLE_BUFFERS_ARB, &buffers);
    return buffers > 0;
}

} // namespace osgTreeWind
