// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/pictures/PanelLabel.h>

#include <osgText/Font>

#include <algorithm>

namespace {

constexpr int glyphWidth = 8, glyphHeight = 12; // of OSG's built-in font

/// Coverage of a letter, bottom row first; null for a space.
const osgText::Glyph* glyphOf(char letter) {
    const osgText::FontResolution resolution(glyphWidth, glyphHeight);
    const auto font = osgText::Font::getDefaultFont();
    return letter == ' ' ? nullptr : font->getGlyph(resolution, static_cast<unsigned char>(letter));
}

/// Blends a pixel with a grey. @param share weight of the grey, 0 to 255.
void mixGrey(unsigned char* pixel, int grey, int share) {
    for (int channel = 0; channel < 3; ++channel)
        pixel[channel] = static_cast<unsigned char>((grey * share + pixel[channel] * (255 - share)) / 255);
}

} // namespace

void writeLabel(osg::Image& picture, const std::string& text) {
    const int scale = std::max(picture.s() / 192, 1), margin = 2 * scale;
    const int width = scale * glyphWidth * static_cast<int>(text.size()) + 2 * margin,
              height = scale * glyphHeight + 2 * margin;
    if (width > picture.s() || height > picture.t())
        return;
    const auto pixel = [&](int x, int y) { return picture.data(x, picture.t() - height + y); };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            mixGrey(pixel(x, y), 0, 150);
    int left = margin;
    for (const char letter : text) {
        if (const osgText::Glyph* glyph = glyphOf(letter))
            for (int y = 0; y < scale * glyph->t(); ++y)
                for (int x = 0; x < scale * glyph->s(); ++x)
                    if (y < height - margin && left + x < width)
                        mixGrey(pixel(left + x, margin + y), 255, *glyph->data(x / scale, y / scale));
        left += scale * glyphWidth;
    }
}
