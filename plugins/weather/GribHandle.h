// SPDX-License-Identifier: MIT
#pragma once

#include <eccodes.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace osgTreeWind {

/// A message of one field, decoded by ecCodes.
class GribHandle {
public:
    /// @param parts that make up the message; only one is not copied.
    explicit GribHandle(const std::vector<std::string_view>& parts);

    /// Null: ecCodes does not know what it is.
    explicit operator bool() const { return _handle != nullptr; }

    /// The number of a key; nothing where there is none.
    std::optional<long> whole(const char* key) const;
    double real(const char* key) const;
    std::string text(const char* key) const;
    /// The byte of the message where a key is; nothing where there is none.
    std::optional<std::size_t> offset(const char* key) const;
    /// A message on the same grid, simply packed, whose so many numbers are 0; empty where it cannot be made.
    std::string emptied(std::size_t numbers) const;
    /// Numbers in the order of the file, NaN where there are none. @return the reason where they cannot be
    /// read.
    std::optional<std::string> read(std::vector<double>& numbers) const;

private:
    std::string _copy;
    std::unique_ptr<codes_handle, int (*)(codes_handle*)> _handle;
};

} // namespace osgTreeWind
