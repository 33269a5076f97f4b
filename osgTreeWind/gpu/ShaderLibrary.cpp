// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osgTreeWind/base/EmbeddedTexts.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/gpu/OpenGLProfile.h>
#include <osgTreeWind/gpu/SharedObjects.h>

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

/// A shader of a program.
struct Part {
    osg::Shader::Type type;
    std::string name, text; ///< Without the lines that depend on the profile.
};

/// The whole text of a shader. The version of a file that 1.0 wrote is dropped.
std::string textInProfile(osg::Shader::Type type, const std::string& text, bool core) {
    std::string result = core ? "#version 330 core\n" : "#version 330 compatibility\n";
    if (type == osg::Shader::VERTEX)
        result += "#define VERTEX_SHADER\n";
    else
        result += "#pragma import_defines(COVERAGE)\n"
                  "#ifdef COVERAGE\n#extension GL_ARB_sample_shading : enable\n#endif\n";
    result += expandIncludes(core ? "core.glsl" : "compatibility.glsl", EmbeddedOnly);
    return result + (text.rfind("#version", 0) == 0 ? text.substr(text.find('\n') + 1) : text);
}

/// The shaders of a program in one profile. They fall back to the embedded shaders if overriding files do not
/// compile or link.
class ProfileProgram : public osg::Program {
public:
    ProfileProgram(const std::string& name, const std::vector<Part>& parts, bool core) : _core(core) {
        setName(name);
        addBindAttribLocation("treePlace", treePlaceLocation);
        addBindAttribLocation("treeSize", treeSizeLocation);
        addBindAttribLocation("treeState", treeStateLocation);
        addBindAttribLocation("treeLight", treeLightLocation);
        for (const Part& part : parts) {
            osg::ref_ptr<osg::Shader> shader =
                new osg::Shader(part.type, textInProfile(part.type, part.text, core));
            shader->setName(part.name);
            addShader(shader);
            _shaders.push_back(shader);
            _overridden = _overridden || (findEmbeddedText("shaders/" + part.name) &&
                                          part.text != expandIncludes(part.name, EmbeddedOnly));
        }
    }

    void apply(osg::State& state) const override {
        osg::Program::apply(state);
        const std::lock_guard<std::mutex> lock(_mutex);
        if (!_overridden || getPCP(state)->isLinked())
            return;
        OSG_WARN << "osgTreeWind: shader files in OSG_FILE_PATH do not work for \"" << getName()
                 << "\"; the embedded shaders are used instead" << std::endl;
        for (const osg::ref_ptr<osg::Shader>& shader : _shaders)
            shader->setShaderSource(
                textInProfile(shader->getType(), expandIncludes(shader->getName(), EmbeddedOnly), _core));
        _overridden = false;
        osg::Program::apply(state);
    }

private:
    bool _core;
    std::vector<osg::ref_ptr<osg::Shader>> _shaders;
    mutable std::mutex _mutex; // contexts may draw in parallel
    mutable bool _overridden = false;
};

/// A program for contexts of both profiles, which may share it. It has no shaders itself: OSG takes it for
/// fixed function, and leaves it alone when it compiles in advance.
class LibraryProgram : public osg::Program {
public:
    LibraryProgram(const std::string& name, const std::vector<Part>& parts)
        : _compatibility(new ProfileProgram(name, parts, false)),
          _core(new ProfileProgram(name, parts, true)) {
        setName(name);
    }
    LibraryProgram(const LibraryProgram& other, const osg::CopyOp& copy)
        : osg::Program(other, copy), _compatibility(other._compatibility), _core(other._core) {}
    osg::Object* clone(const osg::CopyOp& copy) const override { return new LibraryProgram(*this, copy); }

    void apply(osg::State& state) const override { inProfileOf(state).apply(state); }
    void compileGLObjects(osg::State& state) const override { inProfileOf(state).compileGLObjects(state); }
    void resizeGLObjectBuffers(unsigned maxSize) override {
        _compatibility->resizeGLObjectBuffers(maxSize);
        _core->resizeGLObjectBuffers(maxSize);
    }
    void releaseGLObjects(osg::State* state) const override {
        _compatibility->releaseGLObjects(state);
        _core->releaseGLObjects(state);
    }

private:
    const osg::Program& inProfileOf(osg::State& state) const {
        return prepareProfile(state) ? *_core : *_compatibility;
    }

    osg::ref_ptr<osg::Program> _compatibility, _core;
};

/// A program for all contexts in which OSG draws.
osg::ref_ptr<osg::Program> programOf(const std::string& name, const std::vector<Part>& parts) {
#ifdef OSG_GL_FIXED_FUNCTION_AVAILABLE
    return new LibraryProgram(name, parts);
#else
    return new ProfileProgram(name, parts, true);
#endif
}

} // namespace

std::string shaderText(const std::string& name) {
    return expandIncludes(name, FilesFirst);
}

osg::ref_ptr<osg::Program> sharedProgram(const std::string& vertex, const std::string& fragment) {
    static SharedObjects<std::array<std::string, 4>, osg::Program> programs;
    const Part parts[] = {{osg::Shader::VERTEX, vertex + ".vert", shaderText(vertex + ".vert")},
                          {osg::Shader::FRAGMENT, fragment + ".frag", shaderText(fragment + ".frag")}};
    return programs.get({parts[0].name, parts[0].text, parts[1].name, parts[1].text}, [&] {
        return programOf("osgTreeWind " + fragment, {parts[0], parts[1]});
    });
}

osg::ref_ptr<osg::Program> makeProgram(const std::string& name, const std::string& vertexText,
                                       const std::string& fragmentText) {
    return programOf("osgTreeWind " + name,
                     {{osg::Shader::VERTEX, name, vertexText}, {osg::Shader::FRAGMENT, name, fragmentText}});
}

} // namespace osgTreeWind
