// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/windfiles/ByteOrder.h>
#include <osgTreeWind/windfiles/WindContent.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace osgTreeWind {

/// A regular grid of vectors from a VTK file, legacy or XML.
struct VtkImage {
    glm::ivec3 points{0};
    glm::dvec3 origin{0.0};
    glm::dvec3 spacing{1.0};
    std::vector<float> levels{}; ///< Heights of the layers of points, if they are not evenly spaced.
    bool ofCells = false;        ///< Vectors belong to cells, one fewer than points along each axis.
    std::string name;            ///< Name of the array of vectors.
    std::vector<float> values;   ///< Three for each point or cell.
    std::vector<float> energy;   ///< Turbulent kinetic energy of each, m^2/s^2. A file may have none.
    std::optional<double> time;  ///< Seconds, if the file contains a time.

    /// Number of vectors along each axis.
    glm::ivec3 vectorCounts() const;
    /// Sets the spacing along axes of one point to 1 and checks the others. @return the problem, or empty.
    std::string normalizeSpacing();
    /// Number of vectors; a double, so that a product of sizes does not overflow.
    double vectorCount() const;
};

/// Whether an array with this name is the turbulent kinetic energy: k, as in OpenFOAM, or TKE.
bool isTurbulentEnergy(std::string_view name);

/// Converts an image to wind.
WindContent windFromVtk(VtkImage&& image, const std::string& format);

/// Reads all numbers in `bytes`. @param wide doubles instead of floats.
template <typename T>
std::vector<T> numbersOf(std::string_view bytes, bool wide, ByteOrder order) {
    const std::size_t size = wide ? 8 : 4;
    std::vector<T> values(bytes.size() / size);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<T>(wide ? numberAt<double>(bytes, i * size, order)
                                        : static_cast<double>(numberAt<float>(bytes, i * size, order)));
    return values;
}

/// Encoding of the arrays of a VTK XML file.
struct VtkPacking {
    ByteOrder order = ByteOrder::Little;
    bool wideHeader = false; ///< Sizes before the data are UInt64 instead of UInt32.
    bool zlib = false;
    bool base64 = false;
};

/// Decodes one array of exactly `size` bytes. A problem has a message only. Allocates no more than the packed
/// bytes can expand to. @param packed from the first byte of the array; more data may follow.
Result<std::string> unpackVtk(std::string_view packed, const VtkPacking& packing, double size);

} // namespace osgTreeWind
