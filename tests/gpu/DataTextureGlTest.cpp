// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>

#include <osgTreeWind/gpu/DataTexture.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/Geometry>
#include <osg/Program>

#include <cstring>

using namespace osgTreeWind;

namespace {

constexpr int side = 80; // pixels: 6400, enough for 5000 texels
constexpr int texels = 5000;

/// A unique value for each texel, outside [0, 1] and not exact in 16 bits.
float expected(int texel, int channel) {
    return (channel % 2 ? -1.0f : 1.0f) * (1.0f + static_cast<float>(texel)) * 3.1415927f +
           1e-3f * static_cast<float>(channel);
}

/// A drawable whose shader reads texel i as those of the library do, and writes one byte of it to pixel i.
osg::ref_ptr<osg::Geometry> makeByteDrawable(const DataTexture& data) {
    const std::string fragment = shaderText("data.glsl") + R"(
uniform sampler2D data;
uniform int channel, shownByte;
out vec4 color;
void main() {
    int i = int(gl_FragCoord.y) * 80 + int(gl_FragCoord.x);
    uint bits = i < 5000 ? floatBitsToUint(dataTexel(data, i)[channel]) : 0u;
    float value = float((bits >> uint(8 * shownByte)) & 255u) / 255.0;
    color = vec4(value, value, value, 1.0);
})";
    osg::ref_ptr<osg::Geometry> quad =
        osg::createTexturedQuadGeometry(osg::Vec3(-1, -1, 0), osg::Vec3(2, 0, 0), osg::Vec3(0, 2, 0));
    quad->setCullingActive(false);
    osg::StateSet* state = quad->getOrCreateStateSet();
    state->setAttributeAndModes(makeProgram("bytes", "void main() { gl_Position = osg_Vertex; }", fragment));
    state->setTextureAttribute(0, data.texture());
    state->addUniform(new osg::Uniform("data", 0));
    state->setMode(GL_DEPTH_TEST, osg::StateAttribute::OFF);
    return quad;
}

class DataTextureGlTest : public GlTest {
protected:
    /// One channel of all texels as the shader reads them.
    std::vector<float> readBack(osg::StateSet& state, int channel) {
        state.getOrCreateUniform("channel", osg::Uniform::INT)->set(channel);
        std::vector<std::uint32_t> bits(texels, 0u);
        for (int shown = 0; shown < 4; ++shown) {
            state.getOrCreateUniform("shownByte", osg::Uniform::INT)->set(shown);
            frame(_time += 0.04);
            for (int i = 0; i < texels; ++i)
                bits[static_cast<std::size_t>(i)] |= std::uint32_t(*image().data(i % side, i / side))
                                                     << (8 * shown);
        }
        std::vector<float> values(texels);
        std::memcpy(values.data(), bits.data(), texels * sizeof(float));
        return values;
    }

private:
    double _time = 0.0;
};

} // namespace

TEST_F(DataTextureGlTest, EveryTexelArrivesUnchanged) {
    const DataTexture data("numbers", texels);
    for (int i = 0; i < texels; ++i)
        for (int channel = 0; channel < 4; ++channel)
            data.data()[4 * i + channel] = expected(i, channel);
    data.dirty();
    osg::ref_ptr<osg::Geometry> shower = makeByteDrawable(data);
    open(side, side);
    viewer().setSceneData(shower);
    for (int channel = 0; channel < 4; ++channel) {
        const std::vector<float> values = readBack(*shower->getStateSet(), channel);
        for (int i = 0; i < texels; ++i)
            ASSERT_EQ(values[static_cast<std::size_t>(i)], expected(i, channel))
                << "texel " << i << ", channel " << channel;
    }
}

TEST_F(DataTextureGlTest, AChangeArrivesInTheNextFrame) {
    const DataTexture data("numbers", texels);
    osg::ref_ptr<osg::Geometry> shower = makeByteDrawable(data);
    open(side, side);
    viewer().setSceneData(shower);
    EXPECT_EQ(readBack(*shower->getStateSet(), 2).back(), 0.0f);
    data.data()[4 * (texels - 1) + 2] = -1234.5678f;
    data.dirty();
    EXPECT_EQ(readBack(*shower->getStateSet(), 2).back(), -1234.5678f);
}

TEST_F(DataTextureGlTest, MayBeEmpty) {
    const DataTexture data("nothing", 0);
    osg::ref_ptr<osg::Geometry> shower = makeByteDrawable(data);
    open(side, side);
    viewer().setSceneData(shower);
    EXPECT_EQ(readBack(*shower->getStateSet(), 0).front(), 0.0f);
}
