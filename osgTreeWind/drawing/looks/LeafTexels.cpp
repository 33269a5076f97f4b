// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/LeafTexels.h>

#include <osgTreeWind/drawing/looks/ByteOf.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

constexpr int twigs = 2, all = 3;

float mean(const LeafTexels& level, int channel) {
    double sum = 0.0;
    for (const glm::vec4& texel : level.texels)
        sum += texel[channel];
    return static_cast<float>(sum / static_cast<double>(level.texels.size()));
}

/// Factor on a channel with which the alpha test keeps a share of it, or as near as texels are fine; 1 if it
/// does so as it is.
float scaleFor(const LeafTexels& level, int channel, float share) {
    if (std::abs(level.coverage(channel) - share) < 0.001f)
        return 1.0f;
    float low = 0.0f, high = 8.0f;
    for (int step = 0; step < 12; ++step)
        (level.coverage(channel, 0.5f * (low + high)) < share ? low : high) = 0.5f * (low + high);
    const float above = level.coverage(channel, high) - share, below = share - level.coverage(channel, low);
    return channel == twigs && below < above ? low : high;
}

LeafTexels halved(const LeafTexels& level) {
    LeafTexels half(level.size / 2);
    for (int y = 0; y < half.size; ++y)
        for (int x = 0; x < half.size; ++x) {
            glm::vec4 sum(0.0f), plain(0.0f);
            for (int i = 0; i < 4; ++i) {
                const glm::vec4& texel = level.at(2 * x + i % 2, 2 * y + i / 2);
                const float weight = texel.a + 1e-3f; // what is empty has no say in colours
                sum += glm::vec4(weight * texel.r, weight * texel.g, texel.b, texel.a);
                plain += glm::vec4(weight);
            }
            half.at(x, y) = {sum.r / plain.r, sum.g / plain.r, 0.25f * sum.b, 0.25f * sum.a};
        }
    return half;
}

} // namespace

float LeafTexels::coverage(int channel, float scale) const {
    const auto kept = std::count_if(texels.begin(), texels.end(), [=](const glm::vec4& texel) {
        return texel[channel] * scale >= alphaThreshold;
    });
    return static_cast<float>(kept) / static_cast<float>(texels.size());
}

osg::ref_ptr<osg::Image> makeLeafImage(LeafTexels level) {
    const int size = level.size, levels = static_cast<int>(std::log2(size)) + 1;
    const float shares[2] = {mean(level, twigs), mean(level, all)};
    std::vector<unsigned char> bytes;
    osg::Image::MipmapDataType offsets;
    for (int i = 0; i < levels; ++i) {
        if (i > 0) {
            offsets.push_back(static_cast<unsigned>(bytes.size()));
            level = halved(level);
        }
        const float scales[2] = {scaleFor(level, twigs, shares[0]), scaleFor(level, all, shares[1])};
        for (glm::vec4 texel : level.texels) {
            texel.b *= scales[0];
            texel.a = glm::max(texel.a * scales[1], texel.b);
            for (int channel = 0; channel < 4; ++channel)
                bytes.push_back(byteOf(texel[channel]));
        }
    }
    auto* data = new unsigned char[bytes.size()];
    std::copy(bytes.begin(), bytes.end(), data);
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setImage(size, size, 1, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, data, osg::Image::USE_NEW_DELETE);
    image->setMipmapLevels(offsets);
    return image;
}

} // namespace osgTreeWind
