// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Texture2D>

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// An array of RGBA32F texels in a texture: element i is at (i % width, i / width). Shaders read it with
/// dataTexel() (shaders/data.glsl). The CPU fills it, or a pass renders into it.
class DataTexture {
public:
    static constexpr int width = 2048, maxRows = 16384;
    /// OSG would rescale larger textures to the limit of OpenGL.
    static constexpr std::size_t maxTexels = std::size_t(width) * maxRows;

    /// Number of rows for a number of texels, at least 1.
    static int rowsFor(std::size_t texels);

    /// @param name of the texture object, for debugging.
    DataTexture(const char* name, std::size_t texels);

    osg::Texture2D* texture() const { return _texture.get(); }

    /// The texels, 4 floats each. Write in update only, then call dirty().
    float* data() const { return reinterpret_cast<float*>(_image->data()); }
    /// Uploads the texels before the next draw in every context.
    void dirty() const { _image->dirty(); }
    /// Writes texels from the first on; ignores texels beyond the size. In update.
    void write(const std::vector<glm::vec4>& texels) const;
    /// write() and dirty().
    void fill(const std::vector<glm::vec4>& texels) const {
        write(texels);
        dirty();
    }

private:
    osg::ref_ptr<osg::Image> _image;
    osg::ref_ptr<osg::Texture2D> _texture;
};

/// Makes an RGBA32F texture for texelFetch(), still without image and size.
osg::ref_ptr<osg::Texture2D> makeFloatTexture(const char* name);
/// Sets the format of such a texture.
void setFloatFormat(osg::Texture2D& texture);

/// Binds a data texture to a texture unit and a sampler uniform. PROTECTED against overrides from above, such
/// as those of shadow techniques.
void bindDataTexture(osg::StateSet& state, const char* sampler, unsigned unit, osg::Texture2D* texture);

} // namespace osgTreeWind
