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

/// The state sets from the root of the scene to a node of the state graph.
class InheritedState {
public:
    explicit InheritedState(const osgUtil::StateGraph* graph) {
        for (; graph; graph = graph->_parent)
            if (graph->getStateSet())
                _sets.push_back(graph->getStateSet());
        std::reverse(_sets.begin(), _sets.end());
    }

    /// A mode as OSG applies it; INHERIT if no state set has it.
    osg::StateAttribute::GLModeValue mode(osg::StateAttribute::GLMode mode) const {
        osg::StateAttribute::GLModeValue result = osg::StateAttribute::INHERIT;
        for (const osg::StateSet* set : _sets)
            replace(result, set->getMode(mode));
        return result;
    }

    const osg::Fog* fog() const {
        const osg::StateAttribute* result = nullptr;
        osg::StateAttribute::OverrideValue former = 0;
        for (const osg::StateSet* set : _sets)
            if (const auto* fog = set->getAttributePair(osg::StateAttribute::FOG))
                if (replace(former, fog->second))
                    result = fog->first;
        return static_cast<const osg::Fog*>(result);
    }

    /// The value of an integer uniform or sampler as text; empty if no state set has it.
    std::string number(const char* name) const {
        int value = 0;
        for (auto set = _sets.rbegin(); set != _sets.rend(); ++set)
            if (const osg::Uniform* uniform = (*set)->getUniform(name))
                return uniform->get(value) ? std::to_string(value) : std::string();
        return {};
    }

private:
    /// Replaces an inherited value by that of the next state set, unless it is overridden.
    static bool replace(unsigned& inherited, unsigned value) {
        const bool isReplaced =
            value != osg::StateAttribute::INHERIT &&
            (!(inherited & osg::StateAttribute::OVERRIDE) || (value & osg::StateAttribute::PROTECTED));
        if (isReplaced)
            inherited = value;
        return isReplaced;
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

void setSceneDefines(osg::StateSet& state, const osgUtil::StateGraph* stateGraph, bool sampleMask) {
    const InheritedState inherited(stateGraph);
    osg::StateSet::DefineList defines;
    const auto define = [&](const char* name, const std::string& value) {
        defines[name] = {value, osg::StateAttribute::ON};
    };
    std::string lights;
    for (unsigned i = 0; i < 8; ++i)
        if (isOn(inherited.mode(GL_LIGHT0 + i)))
            lights += (lights.empty() ? "" : ", ") + std::to_string(i);
    if (!lights.empty())
        define("LIGHTS", lights);
    const auto lighting = inherited.mode(GL_LIGHTING);
    if (lighting != osg::StateAttribute::INHERIT && !isOn(lighting))
        define("UNLIT", "1");
    if (isOn(inherited.mode(GL_FOG)))
        define("FOG_MODE", fogMode(inherited.fog()));
    if (isOn(inherited.mode(GL_FRAMEBUFFER_SRGB)))
        define("LINEAR_COLORS", "1");
    const auto multisample = inherited.mode(GL_MULTISAMPLE_ARB);
    if (sampleMask && (multisample == osg::StateAttribute::INHERIT || isOn(multisample)))
        define("COVERAGE", "1");
    const std::string shadowMap = inherited.number("osgShadow_shadowTexture");
    if (!shadowMap.empty())
        define("SHADOW_MAP", shadowMap);
    const std::string first = inherited.number("shadowTexture0"), second = inherited.number("shadowTexture1");
    if (!first.empty()) {
        define("SHADOW_MAPS", second.empty() ? "1" : "2");
        define("SHADOW_MAP_UNIT0", first);
        if (!second.empty())
            define("SHADOW_MAP_UNIT1", second);
    }
    state.setDefineList(defines);
}

bool supportsSampleMask(const osg::Camera& camera, const osg::State& state) {
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
