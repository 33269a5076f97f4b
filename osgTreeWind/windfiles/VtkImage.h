// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/windfiles/ByteOrder.h>
#include <osgTreeWind/windfiles/WindContent.h>

#include <cstddef>
#include <functional>
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
    std::string note;            ///< The arrays of the wind, and others that may be named.
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

/// An array of the points or cells of a VTK file.
struct VtkArray {
    std::string name;
    double components = 1.0;
    bool ofCells = false;
    bool isActive = false; ///< Declared as the vectors of the data.
};

/// Reads the wind, and the turbulent kinetic energy (k, as in OpenFOAM, or TKE) of the same points or cells.
/// Without `variable`, the wind is the active array of 3 components, otherwise U, velocity or wind in any
/// case, otherwise the only one.
/// @param arrays all arrays of the file. @param variable as WindFileOptions::variable: an array of 3
/// components, or 2 or 3 arrays of one.
/// @param read reads the array with this index; false after a problem.
/// @return the problem of the choice, with the arrays to choose from; empty if there is none.
std::string readVtkWind(const std::vector<VtkArray>& arrays, const std::vector<std::string>& variable,
                        const std::function<bool(std::size_t, std::vector<float>&)>& read, VtkImage& image);

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
