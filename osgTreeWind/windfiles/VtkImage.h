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

/// What both VTK formats say about a regular grid of vectors. Not part of the interface.
struct VtkImage {
    glm::ivec3 points{0};
    glm::dvec3 origin{0.0};
    glm::dvec3 spacing{1.0};
    std::vector<float> levels{}; ///< Of the points upward, where they are not evenly spaced.
    bool ofCells = false;        ///< The vectors belong to cells, one fewer than points each way.
    std::string name;            ///< Of the array of vectors.
    std::vector<float> values;   ///< Three for each point or cell.
    std::optional<double> time;  ///< Seconds; where the file says when this wind is.

    /// Points or cells each way.
    glm::ivec3 vectors() const;
    /// What keeps the spacing from being one, whose number along an axis of one point does not matter; empty:
    /// nothing.
    std::string settleSpacing();
    /// How many vectors there are; a double, so that no product of sizes overflows.
    double count() const;
};

/// An image as wind; the values move out of it.
WindContent windOfVtk(VtkImage&& image, const std::string& format);

/// The numbers in `bytes`. @param wide 8 bytes each, else 4.
template <typename T>
std::vector<T> numbersOf(std::string_view bytes, bool wide, ByteOrder order) {
    const std::size_t size = wide ? 8 : 4;
    std::vector<T> values(bytes.size() / size);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<T>(wide ? numberAt<double>(bytes, i * size, order)
                                        : static_cast<double>(numberAt<float>(bytes, i * size, order)));
    return values;
}

/// How the arrays of a VTK XML file are packed. Not part of the interface.
struct VtkPacking {
    ByteOrder order = ByteOrder::Little;
    bool wideHeader = false; ///< UInt64 before the data, else UInt32.
    bool zlib = false;
    bool base64 = false;
};

/// The bytes of one array, exactly `size` of them, or what is wrong (a message only). No memory is asked for
/// that the packed bytes could not fill.
/// @param packed from the array's first byte on; more may follow.
Result<std::string> unpackVtk(std::string_view packed, const VtkPacking& packing, double size);

} // namespace osgTreeWind
