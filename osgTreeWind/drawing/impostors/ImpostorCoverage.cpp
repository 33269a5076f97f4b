// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/impostors/ImpostorCoverage.h>

#include <osgTreeWind/drawing/impostors/ImpostorPainter.h>

namespace osgTreeWind {

ImpostorCoverage::ImpostorCoverage(const ImpostorPictures& pictures)
    : _grids(static_cast<std::size_t>(pictures.elevations), Grid{}) {
    const int margin = static_cast<int>(ImpostorPictures::margin * static_cast<float>(pictures.pixels));
    const int inner = pictures.pixels - 2 * margin;
    std::array<float, side * side> texels{};
    for (int y = 0; y < inner; ++y)
        for (int x = 0; x < inner; ++x)
            texels[static_cast<std::size_t>(y * side / inner * side + x * side / inner)] +=
                255.0f * static_cast<float>(pictures.azimuths);
    for (int elevation = 0; elevation < pictures.elevations; ++elevation)
        for (int y = 0; y < inner; ++y) {
            const unsigned char* row = pictures.colors->data( // osg::Image::data() is slow per texel
                0, static_cast<unsigned>(elevation * pictures.pixels + margin + y));
            for (int x = 0; x < inner; ++x) {
                const auto place = static_cast<std::size_t>(y * side / inner * side + x * side / inner);
                for (int azimuth = 0; azimuth < pictures.azimuths; ++azimuth)
                    _grids[static_cast<std::size_t>(elevation)][place] +=
                        row[4 * (azimuth * pictures.pixels + margin + x) + 3] / texels[place];
            }
        }
}

} // namespace osgTreeWind
