// SPDX-License-Identifier: MIT
#include <tests/gpu/FilePath.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/base/EmbeddedTexts.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/Notify>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

struct Warnings : osg::NotifyHandler {
    void notify(osg::NotifySeverity severity, const char* message) override {
        if (severity <= osg::WARN)
            text += message;
    }
    std::string text;
};

} // namespace

TEST(ShaderLibraryTest, leavesNoIncludeUnexpanded) {
    int shaders = 0;
    for (const EmbeddedText& text : embeddedTexts()) {
        if (text.name.rfind("shaders/", 0) != 0)
            continue;
        EXPECT_EQ(shaderText(text.name.substr(8)).find("\n#include"), std::string::npos) << text.name;
        ++shaders;
    }
    EXPECT_GT(shaders, 30);
    EXPECT_NE(shaderText("branchwise/bark.vert").find("vec4 dataTexel"), std::string::npos)
        << "from data.glsl, which tree.glsl includes";
}

TEST(ShaderLibraryTest, aFileInTheFilePathTakesTheEmbeddedOnesPlace) {
    const TemporaryFolder folder;
    folder.write("light.glsl", "// mine\n");
    const FilePath path(folder.path());
    EXPECT_EQ(shaderText("light.glsl"), "// mine\n");
    EXPECT_NE(shaderText("branchwise/bark.vert").find("// mine\n"), std::string::npos)
        << "also where it is included";
}

TEST(ShaderLibraryTest, aShaderThatIncludesItselfEnds) {
    const TemporaryFolder folder;
    folder.write("loop.glsl", "#include \"loop.glsl\"\n");
    const FilePath path(folder.path());
    EXPECT_LT(shaderText("loop.glsl").size(), 1000u);
}

TEST(ShaderLibraryTest, anUnknownNameGivesNothingAndAWarning) {
    osg::ref_ptr<Warnings> warnings = new Warnings;
    osg::ref_ptr<osg::NotifyHandler> former = osg::getNotifyHandler();
    osg::setNotifyHandler(warnings);
    EXPECT_EQ(shaderText("no such.glsl"), "");
    osg::setNotifyHandler(former);
    EXPECT_NE(warnings->text.find("\"no such.glsl\""), std::string::npos);
}

TEST(ShaderLibraryTest, aProgramHasItsTwoShadersAndAName) {
    osg::ref_ptr<osg::Program> program = sharedProgram("branchwise/bark", "bark");
    ASSERT_EQ(program->getNumShaders(), 2u);
    EXPECT_EQ(program->getShader(0)->getType(), osg::Shader::VERTEX);
    EXPECT_EQ(program->getShader(1)->getType(), osg::Shader::FRAGMENT);
    EXPECT_NE(program->getName().find("bark"), std::string::npos);
}
