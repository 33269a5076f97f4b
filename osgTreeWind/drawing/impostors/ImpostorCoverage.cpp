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
    for (int y = 0; y < inner; ++y)
        for (int x = 0; x < inner; ++x) {
            const auto place = static_cast<std::size_t>(y * side / inner * side + x * side / inner);
            for (int elevation = 0; elevation < pictures.elevations; ++elevation)
                for (int azimuth = 0; azimuth < pictures.azimuths; ++azimuth) {
                    const unsigned char* texel = pictures.colors->data(
                        static_cast<unsigned>(azimuth * pictures.pixels + margin + x),
                        static_cast<unsigned>(elevation * pictures.pixels + margin + y));
                    _grids[static_cast<std::size_t>(elevation)][place] += texel[3] / texels[place];
                }
        }
}

} // namespace osgTreeWind
