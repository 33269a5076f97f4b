// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osgTreeWind/gpu/EmbeddedShaders.h>

#include <osg/Notify>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include <fstream>
#include <iterator>
#include <sstream>

namespace osgTreeWind {
namespace {

std::string fileText(const std::string& name) {
    const std::string path = osgDB::findFileInPath(name, osgDB::getDataFilePathList());
    if (!path.empty()) {
        std::ifstream file(path);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
    for (const EmbeddedShader& shader : embeddedShaders())
        if (name == shader.name)
            return shader.text;
    OSG_WARN << "osgTreeWind: no shader called \"" << name << "\"" << std::endl;
    return {};
}

std::string expanded(const std::string& name, int depth) {
    constexpr const char* directive = "#include \"";
    std::istringstream input(fileText(name));
    std::string text, line;
    while (std::getline(input, line)) {
        const std::size_t start =
            line.rfind(directive, 0) == 0 ? std::char_traits<char>::length(directive) : 0;
        const std::size_t end = start ? line.find('"', start) : std::string::npos;
        if (end != std::string::npos && depth < 8)
            text += expanded(line.substr(start, end - start), depth + 1);
        else
            text += line + '\n';
    }
    return text;
}

} // namespace

std::string shaderText(const std::string& name) {
    return expanded(name, 0);
}

osg::ref_ptr<osg::Program> createProgram(const std::string& vertex, const std::string& fragment) {
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("osgTreeWind " + fragment);
    const auto add = [&](osg::Shader::Type type, const std::string& name) {
        osg::ref_ptr<osg::Shader> shader = new osg::Shader(type, shaderText(name));
        shader->setName(name);
        program->addShader(shader);
    };
    add(osg::Shader::VERTEX, vertex + ".vert");
    add(osg::Shader::FRAGMENT, fragment + ".frag");
    return program;
}

} // namespace osgTreeWind
