// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Texture2D>

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// An array of RGBA32F texels as a texture: element i stands at (i % width, i / width). Shaders read it with
/// dataTexel() (shaders/data.glsl). Filled on the CPU, or the target of a pass.
class DataTexture {
public:
    static constexpr int width = 2048, mostRows = 16384;
    /// More would be a texture that OpenGL does not hold, and OSG would rescale.
    static constexpr std::size_t mostTexels = std::size_t(width) * mostRows;

    /// Rows that so many texels take, at least 1.
    static int rowsFor(std::size_t texels);

    /// @param name of the texture, for people who look at the scene.
    DataTexture(const char* name, std::size_t texels);

    osg::Texture2D* texture() const { return _texture.get(); }

    /// The texels, 4 floats each. Write only during update, then call dirty().
    float* data() const { return reinterpret_cast<float*>(_image->data()); }
    /// Has the texels uploaded before the next draw in every context.
    void dirty() const { _image->dirty(); }
    /// Writes texels from the first on; no more than there are. During update.
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

/// A texture of RGBA32F texels that are fetched one by one, without image or size.
osg::ref_ptr<osg::Texture2D> makeFloatTexture(const char* name);

/// Gives a texture of data to the shaders below `state`, as `sampler` in a texture unit. Protected, since a
/// shadow technique, say, overrides textures of the scene above.
void bindData(osg::StateSet& state, const char* sampler, unsigned unit, osg::Texture2D* texture);

} // namespace osgTreeWind
