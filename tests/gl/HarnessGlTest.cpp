// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>

#include <osg/Geometry>
#include <osg/Program>

namespace {

/// Hands OpenGL a value it must refuse.
struct WrongCall : osg::Drawable::DrawCallback {
    void drawImplementation(osg::RenderInfo&, const osg::Drawable*) const override { glEnable(0xffff); }
};

class HarnessGlTest : public GlTest {};

} // namespace

TEST_F(HarnessGlTest, hearsOfAnOpenGLErrorInADrawable) {
    osg::ref_ptr<osg::Geometry> wrong =
        osg::createTexturedQuadGeometry(osg::Vec3(-1, 0, -1), osg::Vec3(2, 0, 0), osg::Vec3(0, 0, 2));
    wrong->setUseDisplayList(false);
    wrong->setDrawCallback(new WrongCall);
    open(8, 8);
    viewer().setSceneData(wrong);
    viewer().getCamera()->setViewMatrixAsLookAt(osg::Vec3(0, -5, 0), osg::Vec3(), osg::Vec3(0, 0, 1));
    viewer().frame(0);
    EXPECT_NE(takeMessages().find("OpenGL error 'invalid enum"), std::string::npos);
}

TEST_F(HarnessGlTest, hearsOfAShaderThatDoesNotCompile) {
    osg::ref_ptr<osg::Geometry> quad =
        osg::createTexturedQuadGeometry(osg::Vec3(-1, 0, -1), osg::Vec3(2, 0, 0), osg::Vec3(0, 0, 2));
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, "void main() { gl_FragColor = nothing; }"));
    quad->getOrCreateStateSet()->setAttributeAndModes(program);
    open(8, 8);
    viewer().setSceneData(quad);
    viewer().getCamera()->setViewMatrixAsLookAt(osg::Vec3(0, -5, 0), osg::Vec3(), osg::Vec3(0, 0, 1));
    viewer().frame(0);
    EXPECT_NE(takeMessages().find("nothing"), std::string::npos);
}
