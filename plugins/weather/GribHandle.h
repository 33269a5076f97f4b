// SPDX-License-Identifier: MIT
#pragma once

#include <eccodes.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace osgTreeWind {

/// A GRIB message of one field, decoded by ecCodes.
class GribHandle {
public:
    /// @param parts of the message, which are copied.
    explicit GribHandle(const std::vector<std::string_view>& parts);

    /// Whether ecCodes can decode it.
    explicit operator bool() const { return _handle != nullptr; }

    /// The value of a key; `otherwise` if the message does not have it.
    long integer(const char* key, long otherwise = 0) const;
    double real(const char* key) const;
    std::string text(const char* key) const;
    /// Changes the copy of the message, if it has this key.
    void set(const char* key, const std::string& value) const;
    /// A message on the same grid with all values 0 in simple packing; empty on failure.
    /// @param numbers expected number of values.
    std::string withZeroValues(std::size_t numbers) const;
    /// Reads all values in the order of the file; NaN if missing. @return the reason of a failure.
    std::optional<std::string> readValues(std::vector<double>& numbers) const;

private:
    using Owned = std::unique_ptr<codes_handle, int (*)(codes_handle*)>;

    std::string _message;
    Owned _handle;
};

} // namespace osgTreeWind
