// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/SceneShading.h>

#include <osg/ClipPlane>
#include <osg/Fog>
#include <osg/GLExtensions>
#include <osg/Light>
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
    InheritedState(const osg::StateSet* stage, const osgUtil::StateGraph* graph) {
        for (; graph; graph = graph->_parent)
            if (graph->getStateSet())
                _sets.push_back(graph->getStateSet());
        if (stage)
            _sets.push_back(stage);
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

    /// Null if no state set has it.
    const osg::Uniform* uniform(const std::string& name) const {
        for (auto set = _sets.rbegin(); set != _sets.rend(); ++set)
            if (const osg::Uniform* uniform = (*set)->getUniform(name))
                return uniform;
        return nullptr;
    }
    /// The value of an integer uniform or sampler as text; empty if no state set has it.
    std::string number(const char* name) const {
        int value = 0;
        const osg::Uniform* found = uniform(name);
        return found && found->get(value) ? std::to_string(value) : std::string();
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

/// Whether a light is on: by its mode, or as a uniform that the host sets (shaders/core.glsl).
bool isLightOn(const InheritedState& inherited, unsigned light) {
    const std::string prefix = "osg_LightSource[" + std::to_string(light) + "].";
    bool enabled = true;
    if (const osg::Uniform* uniform = inherited.uniform(prefix + "enabled"))
        uniform->get(enabled);
    return isOn(inherited.mode(GL_LIGHT0 + light)) || (enabled && inherited.uniform(prefix + "position"));
}

} // namespace

void setSceneDefines(osg::StateSet& state, const osg::StateSet* stage, const osgUtil::StateGraph* stateGraph,
                     bool sampleMask) {
    const InheritedState inherited(stage, stateGraph);
    osg::StateSet::DefineList defines;
    const auto define = [&](const char* name, const std::string& value) {
        defines[name] = {value, osg::StateAttribute::ON};
    };
    std::string lights;
    for (unsigned i = 0; i < 8; ++i)
        if (isLightOn(inherited, i))
            lights += (lights.empty() ? "" : ", ") + std::to_string(i);
    if (!lights.empty())
        define("LIGHTS", lights);
    const auto lighting = inherited.mode(GL_LIGHTING);
    if (lighting != osg::StateAttribute::INHERIT && !isOn(lighting))
        define("UNLIT", "1");
    if (isOn(inherited.mode(GL_FOG)))
        define("FOG_MODE", fogMode(inherited.fog()));
    for (unsigned i = 0; i < 8; ++i)
        if (isOn(inherited.mode(GL_CLIP_PLANE0 + i)))
            define("CLIP_PLANES", std::to_string(i + 1));
    if (isOn(inherited.mode(GL_FRAMEBUFFER_SRGB)))
        define("ENCODED_BY_OPENGL", "1");
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
    if (const osg::Uniform* slices = inherited.uniform("oe_shadow_matrix"))
        define("SHADOW_SLICES", std::to_string(slices->getNumElements()));
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
