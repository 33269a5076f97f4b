// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/windfiles/ByteOrder.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace osgTreeWind {

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
