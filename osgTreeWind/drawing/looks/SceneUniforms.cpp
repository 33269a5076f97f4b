// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/SceneUniforms.h>

#include <osg/ClipPlane>
#include <osg/Fog>
#include <osg/GLExtensions>
#include <osg/Light>
#include <osg/LightModel>
#include <osg/TexGen>
#include <osg/View>
#include <osgUtil/RenderBin>
#include <osgUtil/RenderStage>

#include <array>
#include <string>
#include <unordered_map>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr unsigned lightCount = 8, clipPlaneCount = 8, textureUnits = 16; // as in shaders/core.glsl

/// Sets uniforms of the program in use.
class ProgramUniforms {
public:
    explicit ProgramUniforms(const osg::State& state)
        : _gl(*state.get<osg::GLExtensions>()), _program(*state.getLastAppliedProgramObject()),
          _ofHost(state.getUniformMap()) {}

    /// Whether the host sets a uniform. OSG would not notice that it has another value.
    bool isOfHost(const std::string& name) const {
        const auto found = _ofHost.find(name);
        return found != _ofHost.end() && !found->second.uniformVec.empty();
    }

    void set(unsigned name, float value) const {
        if (const GLint at = _program.getUniformLocation(name); at >= 0)
            _gl.glUniform1f(at, value);
    }
    void set(unsigned name, const osg::Vec3& value) const {
        if (const GLint at = _program.getUniformLocation(name); at >= 0)
            _gl.glUniform3fv(at, 1, value.ptr());
    }
    void set(unsigned name, const osg::Vec4& value) const {
        if (const GLint at = _program.getUniformLocation(name); at >= 0)
            _gl.glUniform4fv(at, 1, value.ptr());
    }
    template <std::size_t count>
    void set(unsigned name, const std::array<osg::Vec4, count>& values) const {
        if (const GLint at = _program.getUniformLocation(name); at >= 0)
            _gl.glUniform4fv(at, count, values[0].ptr());
    }
    template <std::size_t count>
    void set(unsigned name, const std::array<osg::Matrixf, count>& values) const {
        if (const GLint at = _program.getUniformLocation(name); at >= 0)
            _gl.glUniformMatrix4fv(at, count, GL_FALSE, values[0].ptr());
    }

private:
    const osg::GLExtensions& _gl;
    const osg::Program::PerContextProgram& _program;
    const osg::State::UniformMap& _ofHost;
};

unsigned nameId(const std::string& name) {
    return osg::Uniform::getNameID(name);
}

/// The names of the uniforms of one light.
struct LightNames {
    explicit LightNames(unsigned number) : prefix("osg_LightSource[" + std::to_string(number) + "].") {}
    std::string prefix;
    std::string hostAmbient = prefix + "ambient", hostDiffuse = prefix + "diffuse",
                hostPosition = prefix + "position";
    unsigned ambient = nameId(prefix + "ambient"), diffuse = nameId(prefix + "diffuse"),
             position = nameId(prefix + "position"), spotDirection = nameId(prefix + "spotDirection"),
             spotExponent = nameId(prefix + "spotExponent"), spotCutoff = nameId(prefix + "spotCutoff"),
             constant = nameId(prefix + "constantAttenuation"), linear = nameId(prefix + "linearAttenuation"),
             quadratic = nameId(prefix + "quadraticAttenuation");
};

const LightNames& lightNames(unsigned number) {
    static const std::array<LightNames, lightCount> names{LightNames(0), LightNames(1), LightNames(2),
                                                          LightNames(3), LightNames(4), LightNames(5),
                                                          LightNames(6), LightNames(7)};
    return names[number];
}

/// Sets what the host does not set.
void setLight(const ProgramUniforms& uniforms, const osg::Light& light, const osg::Matrix& toEye) {
    const LightNames& names = lightNames(static_cast<unsigned>(light.getLightNum()));
    if (uniforms.isOfHost(names.hostPosition))
        return;
    if (!uniforms.isOfHost(names.hostAmbient))
        uniforms.set(names.ambient, light.getAmbient());
    if (!uniforms.isOfHost(names.hostDiffuse))
        uniforms.set(names.diffuse, light.getDiffuse());
    uniforms.set(names.position, osg::Vec4(light.getPosition() * toEye));
    uniforms.set(names.spotDirection, osg::Matrix::transform3x3(light.getDirection(), toEye));
    uniforms.set(names.spotExponent, light.getSpotExponent());
    uniforms.set(names.spotCutoff, light.getSpotCutoff());
    uniforms.set(names.constant, light.getConstantAttenuation());
    uniforms.set(names.linear, light.getLinearAttenuation());
    uniforms.set(names.quadratic, light.getQuadraticAttenuation());
}

/// The planes of a TexGen in eye space, as the rows of a matrix that OpenGL reads by columns.
osg::Matrixf eyePlanes(const osg::TexGen& planes, const osg::Matrix& toEye) {
    const osg::Matrix fromEye = osg::Matrix::inverse(toEye);
    osg::Matrixf result;
    int row = 0;
    for (const osg::TexGen::Coord coord : {osg::TexGen::S, osg::TexGen::T, osg::TexGen::R, osg::TexGen::Q}) {
        const osg::Vec4d plane = fromEye * planes.getPlane(coord).asVec4();
        for (int column = 0; column < 4; ++column)
            result(column, row) = static_cast<float>(plane[column]);
        ++row;
    }
    return result;
}

/// Light 0 before a host sets it.
const osg::Light* openGLsLight() {
    static const osg::ref_ptr<osg::Light> light = [] {
        osg::ref_ptr<osg::Light> made = new osg::Light;
        made->setAmbient(osg::Vec4(0.0f, 0.0f, 0.0f, 1.0f));
        made->setDiffuse(osg::Vec4(1.0f, 1.0f, 1.0f, 1.0f));
        return made;
    }();
    return light;
}

/// The positional state of a render stage: lights, clip planes and shadow planes, in eye space.
class PositionalUniforms {
public:
    explicit PositionalUniforms(const ProgramUniforms& uniforms) : _uniforms(uniforms) {
        addLight(*openGLsLight(), osg::Matrix());
    }

    void add(const osg::View& view) {
        if (view.getLight() && view.getLightingMode() != osg::View::NO_LIGHT)
            addLight(*view.getLight(), view.getLightingMode() == osg::View::SKY_LIGHT && view.getCamera()
                                           ? view.getCamera()->getViewMatrix()
                                           : osg::Matrix());
    }
    void add(osgUtil::PositionalStateContainer& container, const osg::Matrix& postMultiplied) {
        for (const auto& [attribute, matrix] : container.getAttrMatrixList()) {
            const osg::Matrix toEye = matrix ? *matrix * postMultiplied : postMultiplied;
            if (const auto* light = dynamic_cast<const osg::Light*>(attribute.get()))
                addLight(*light, toEye);
            else if (const auto* clip = dynamic_cast<const osg::ClipPlane*>(attribute.get());
                     clip && clip->getClipPlaneNum() < clipPlaneCount)
                _clipPlanes[clip->getClipPlaneNum()] = osg::Matrix::inverse(toEye) * clip->getClipPlane();
        }
        for (const auto& [unit, attributes] : container.getTexUnitAttrMatrixListMap())
            for (const auto& [attribute, matrix] : attributes)
                if (const auto* planes = dynamic_cast<const osg::TexGen*>(attribute.get());
                    planes && unit < textureUnits)
                    _eyePlanes[unit] = eyePlanes(*planes, matrix ? *matrix * postMultiplied : postMultiplied);
    }
    void apply() const {
        for (const auto& [light, toEye] : _lights)
            if (light)
                setLight(_uniforms, *light, toEye);
        static const unsigned clipPlanes = nameId("sceneClipPlanes"), planes = nameId("sceneEyePlanes");
        _uniforms.set(clipPlanes, _clipPlanes);
        _uniforms.set(planes, _eyePlanes);
    }

private:
    void addLight(const osg::Light& light, const osg::Matrix& toEye) {
        if (const auto number = static_cast<unsigned>(light.getLightNum()); number < lightCount)
            _lights[number] = {&light, toEye};
    }

    const ProgramUniforms& _uniforms;
    std::array<std::pair<const osg::Light*, osg::Matrix>, lightCount> _lights{};
    std::array<osg::Vec4, clipPlaneCount> _clipPlanes{};
    std::array<osg::Matrixf, textureUnits> _eyePlanes{};
};

void setFog(const ProgramUniforms& uniforms, const osg::Fog& fog) {
    static const unsigned color = nameId("sceneFog.color"), density = nameId("sceneFog.density"),
                          end = nameId("sceneFog.end"), scale = nameId("sceneFog.scale");
    uniforms.set(color, fog.getColor());
    uniforms.set(density, fog.getDensity());
    uniforms.set(end, fog.getEnd());
    uniforms.set(scale, 1.0f / (fog.getEnd() - fog.getStart()));
}

} // namespace

void applySceneUniforms(osg::RenderInfo& renderInfo, std::uint64_t scope) {
    const osg::State& state = *renderInfo.getState();
    if (!state.getLastAppliedProgramObject())
        return;
    thread_local std::unordered_map<const osg::Program::PerContextProgram*, std::uint64_t> lastScopes;
    std::uint64_t& lastScope = lastScopes[state.getLastAppliedProgramObject()];
    if (scope != 0 && scope == lastScope)
        return;
    lastScope = scope;
    const ProgramUniforms uniforms(state);
    PositionalUniforms positional(uniforms);
    if (renderInfo.getView())
        positional.add(*renderInfo.getView());
    if (!renderInfo.getRenderBinStack().empty()) {
        osgUtil::RenderStage& stage = *renderInfo.getRenderBinStack().back()->getStage();
        if (auto* inherited = stage.getInheritedPositionalStateContainer())
            positional.add(*inherited, stage.getInheritedPositionalStateContainerMatrix());
        positional.add(*stage.getPositionalStateContainer(), osg::Matrix());
    }
    positional.apply();

    static const unsigned ambient = nameId("sceneAmbient");
    const auto* model =
        dynamic_cast<const osg::LightModel*>(state.getLastAppliedAttribute(osg::StateAttribute::LIGHTMODEL));
    uniforms.set(ambient, model ? model->getAmbientIntensity()
                                : osg::Vec4(0.1f, 0.1f, 0.1f, 1.0f)); // as osgUtil::SceneView sets
    if (const auto* fog =
            dynamic_cast<const osg::Fog*>(state.getLastAppliedAttribute(osg::StateAttribute::FOG)))
        setFog(uniforms, *fog);
}

} // namespace osgTreeWind
