// SPDX-License-Identifier: MIT
#include "../gl/GlTest.h"
#include "ForestFixtures.h"
#include "Pictures.h"

#include <osgTreeWind/gpu/ShaderLibrary.h>
#include <osgTreeWind/motion/BuiltInSpecies.h>
#include <osgTreeWind/nodes/ImpostorShape.h>

#include <osg/GLExtensions>

#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr int size = 128; // pixels

/// What an instance has as vertex attributes.
struct Instance : osg::Drawable::DrawCallback {
    osg::Vec4 place{0, 0, 0, 0}, scale{1, 1, 1, 1}, state{0, 0, 1, 0};

    void drawImplementation(osg::RenderInfo& info, const osg::Drawable* drawable) const override {
        osg::GLExtensions* gl = info.getState()->get<osg::GLExtensions>();
        gl->glVertexAttrib4fv(treePlaceLocation, place.ptr());
        gl->glVertexAttrib4fv(treeSizeLocation, scale.ptr());
        gl->glVertexAttrib4fv(treeStateLocation, state.ptr());
        drawable->drawImplementation(info);
    }
};

/// Where a tree is seen from; angles in degrees.
struct Sight {
    double azimuth, elevation, pixels;
};

Species speciesCalled(const std::string& name) {
    return name == "thesis" ? Species() : *findBuiltInSpecies(name);
}

/// Mean colours of blocks of 8 x 8 pixels in which either picture shows something.
double blockDifference(const osg::Image& a, const osg::Image& b) {
    double sum = 0.0;
    int blocks = 0;
    for (int y = 0; y < size; y += 8)
        for (int x = 0; x < size; x += 8) {
            double difference[3] = {0, 0, 0}, total = 0.0;
            for (int i = 0; i < 64; ++i)
                for (int c = 0; c < 3; ++c) {
                    const int one = *(a.data(x + i % 8, y + i / 8) + c),
                              other = *(b.data(x + i % 8, y + i / 8) + c);
                    difference[c] += (one - other) / 64.0;
                    total += one + other;
                }
            if (total == 0.0)
                continue;
            ++blocks;
            for (const double d : difference)
                sum += std::abs(d) / 3.0;
        }
    return sum / blocks;
}

class ImpostorGlTest : public GlTest {
protected:
    osg::ref_ptr<osg::Image> picture(osg::Node* node, const Sight& sight, float height) {
        open(size, size);
        viewer().setSceneData(node);
        viewer().setLightingMode(osg::View::SKY_LIGHT);
        viewer().getLight()->setPosition(osg::Vec4(0.5f, -0.7f, 0.8f, 0.0f));
        osg::Camera& camera = *viewer().getCamera();
        const double a = osg::DegreesToRadians(sight.azimuth), e = osg::DegreesToRadians(sight.elevation);
        const osg::Vec3d middle(0, 0, 0.5 * height), to(cos(a) * cos(e), sin(a) * cos(e), sin(e));
        const double distance = 0.5 * size / sight.pixels * height / tan(osg::DegreesToRadians(15.0));
        camera.setClearColor(osg::Vec4(0, 0, 0, 1));
        camera.setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
        camera.setProjectionMatrixAsPerspective(30, 1, 0.1 * distance, 3 * distance);
        camera.setViewMatrixAsLookAt(middle + to * distance, middle, osg::Z_AXIS);
        frame(0.0);
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }

    osg::ref_ptr<ImpostorShape> shapeOf(const Species& species, const ImpostorSettings& settings = {}) {
        const TreeModel model = makeTreeModel(species.tree);
        return new ImpostorShape(paintImpostor(model, species.appearance, settings),
                                 createProgram("impostor", "impostor"));
    }

    osg::ref_ptr<osg::Node> impostor(ImpostorShape& shape, Instance* instance) {
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry(*shape.geometry());
        geometry->setDrawCallback(instance);
        geometry->setCullingActive(false);
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->addChild(geometry);
        group->setCullingActive(false);
        group->setStateSet(new osg::StateSet(*shape.stateSet()));
        group->getStateSet()->addUniform(new osg::Uniform("leanPower", 1.5f));
        return group;
    }
};

} // namespace

TEST_F(ImpostorGlTest, looksLikeTheTreeDrawnInFull) {
    for (const char* name : {"thesis", "oak", "birch", "Norway spruce", "Scots pine", "larch"}) {
        const Species species = speciesCalled(name);
        osg::ref_ptr<ImpostorShape> shape = shapeOf(species);
        osg::ref_ptr<osg::Node> flat = impostor(*shape, new Instance),
                                full = new Forest(oneTree(species, 0.0f));
        for (const double pixels : {25.0, 50.0}) {
            double blocks = 0.0, areas[2] = {0.0, 0.0};
            const double sights[][2] = {{0, 0}, {22.5, 0}, {100, 15}, {200, 30}, {300, 45}};
            for (const auto& [azimuth, elevation] : sights) {
                const Sight sight{azimuth, elevation, pixels};
                osg::ref_ptr<osg::Image> a = picture(full, sight, shape->pictures().height),
                                         b = picture(flat, sight, shape->pictures().height);
                blocks += blockDifference(*a, *b) / 5.0;
                areas[0] += covered(*a);
                areas[1] += covered(*b);
            }
            EXPECT_LT(blocks, 3.0) << name << ", " << pixels;
            EXPECT_NEAR(areas[1] / areas[0], 1.0, 0.12) << name << ", " << pixels;
        }
    }
}
