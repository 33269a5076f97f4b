// SPDX-License-Identifier: MIT
#include <tests/MessageCollector.h>
#include <tests/gpu/FilePath.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/base/EmbeddedTexts.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

TEST(ShaderLibraryTest, ExpandsAllIncludes) {
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

TEST(ShaderLibraryTest, AFileInTheFilePathOverridesTheEmbeddedShader) {
    const TemporaryFolder folder;
    folder.write("light.glsl", "// mine\n");
    const FilePath path(folder.path());
    EXPECT_EQ(shaderText("light.glsl"), "// mine\n");
    EXPECT_NE(shaderText("branchwise/bark.vert").find("// mine\n"), std::string::npos)
        << "also where it is included";
}

TEST(ShaderLibraryTest, AShaderThatIncludesItselfEnds) {
    const TemporaryFolder folder;
    folder.write("loop.glsl", "#include \"loop.glsl\"\n");
    const FilePath path(folder.path());
    EXPECT_LT(shaderText("loop.glsl").size(), 1000u);
}

TEST(ShaderLibraryTest, AnUnknownNameGivesAnEmptyTextAndAWarning) {
    const ScopedMessages messages;
    EXPECT_EQ(shaderText("no such.glsl"), "");
    EXPECT_NE(messages.take().find("\"no such.glsl\""), std::string::npos);
}

TEST(ShaderLibraryTest, AProgramIsSharedAndHasAName) {
    osg::ref_ptr<osg::Program> program = sharedProgram("branchwise/bark", "bark");
    EXPECT_EQ(program, sharedProgram("branchwise/bark", "bark"));
    EXPECT_NE(program->getName().find("bark"), std::string::npos);
}
