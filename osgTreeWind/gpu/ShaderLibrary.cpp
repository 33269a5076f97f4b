// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osgTreeWind/base/EmbeddedTexts.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/gpu/SharedObjects.h>

#include <osg/GLExtensions>
#include <osg/Notify>
#include <osg/State>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include <array>
#include <fstream>
#include <mutex>
#include <sstream>
#include <vector>

namespace osgTreeWind {
namespace {

/// Source of the text of a shader.
enum Source { FilesFirst, EmbeddedOnly };

std::string fileText(const std::string& name, Source source) {
    const std::string path =
        source == FilesFirst ? osgDB::findFileInPath(name, osgDB::getDataFilePathList()) : std::string();
    if (!path.empty()) {
        const Result<std::string> text = readTextFile(path);
        if (text)
            return text.value();
        OSG_WARN << "osgTreeWind: " << text.problems().front().text() << std::endl;
    }
    if (const EmbeddedText* shader = findEmbeddedText("shaders/" + name))
        return shader->text;
    OSG_WARN << "osgTreeWind: no shader called \"" << name << "\"" << std::endl;
    return {};
}

std::string expandIncludes(const std::string& name, Source source, int depth = 0) {
    constexpr const char* directive = "#include \"";
    std::istringstream input(fileText(name, source));
    std::string text, line;
    while (std::getline(input, line)) {
        const std::size_t start =
            line.rfind(directive, 0) == 0 ? std::char_traits<char>::length(directive) : 0;
        const std::size_t end = start ? line.find('"', start) : std::string::npos;
        if (end != std::string::npos && depth < 8)
            text += expandIncludes(line.substr(start, end - start), source, depth + 1);
        else
            text += line + '\n';
    }
    return text;
}

struct Text {
    explicit Text(const std::string& shader) : name(shader), text(expandIncludes(shader, FilesFirst)) {}
    std::string name, text;
};

/// A program that falls back to the embedded shaders if overriding files do not compile or link.
class OverridableProgram : public osg::Program {
public:
    void add(osg::Shader::Type type, const Text& given) {
        osg::ref_ptr<osg::Shader> shader = new osg::Shader(type, given.text);
        shader->setName(given.name);
        _overridden = _overridden || given.text != expandIncludes(given.name, EmbeddedOnly);
        addShader(shader);
        _shaders.push_back(shader);
    }

    void compileGLObjects(osg::State& state) const override {
        if (canRunPrograms(state))
            osg::Program::compileGLObjects(state);
    }

    void apply(osg::State& state) const override {
        if (!canRunPrograms(state))
            return;
        osg::Program::apply(state);
        const std::lock_guard<std::mutex> lock(_mutex);
        if (!_overridden || getPCP(state)->isLinked())
            return;
        OSG_WARN << "osgTreeWind: shader files in OSG_FILE_PATH do not work for \"" << getName()
                 << "\"; the embedded shaders are used instead" << std::endl;
        for (const osg::ref_ptr<osg::Shader>& shader : _shaders)
            shader->setShaderSource(expandIncludes(shader->getName(), EmbeddedOnly));
        _overridden = false;
        osg::Program::apply(state);
    }

private:
    std::vector<osg::ref_ptr<osg::Shader>> _shaders;
    mutable std::mutex _mutex; // contexts may draw in parallel
    mutable bool _overridden = false;
};

} // namespace

std::string shaderText(const std::string& name) {
    return expandIncludes(name, FilesFirst);
}

bool canRunPrograms(const osg::State& state) {
    static std::once_flag said;
    GLint profile = 0;
    if (state.get<osg::GLExtensions>()->glVersion >= 3.2f)
        glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    if (!(profile & GL_CONTEXT_CORE_PROFILE_BIT))
        return true;
    std::call_once(said, [] {
        OSG_WARN << "osgTreeWind: trees are not drawn in an OpenGL core profile; expected a compatibility "
                    "profile, as the shaders of `#version 330 compatibility` need it"
                 << std::endl;
    });
    return false;
}

osg::ref_ptr<osg::Program> sharedProgram(const std::string& vertex, const std::string& fragment) {
    static SharedObjects<std::array<std::string, 4>, osg::Program> programs;
    const Text vertexText(vertex + ".vert"), fragmentText(fragment + ".frag");
    return programs.get({vertexText.name, vertexText.text, fragmentText.name, fragmentText.text}, [&] {
        osg::ref_ptr<OverridableProgram> program = new OverridableProgram;
        program->setName("osgTreeWind " + fragment);
        program->addBindAttribLocation("treePlace", treePlaceLocation);
        program->addBindAttribLocation("treeSize", treeSizeLocation);
        program->addBindAttribLocation("treeState", treeStateLocation);
        program->addBindAttribLocation("treeLight", treeLightLocation);
        program->add(osg::Shader::VERTEX, vertexText);
        program->add(osg::Shader::FRAGMENT, fragmentText);
        return osg::ref_ptr<osg::Program>(program);
    });
}

} // namespace osgTreeWind
