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

    /// Whether ecCodes can decode it.
    explicit operator bool() const { return _handle != nullptr; }

    /// The value of a key; empty if the message does not have it.
    std::optional<long> whole(const char* key) const;
    double real(const char* key) const;
    std::string text(const char* key) const;
    /// The offset of a key in the message, bytes; empty if the message does not have it.
    std::optional<std::size_t> offset(const char* key) const;
    /// A message on the same grid with all its numbers 0, simply packed; empty on failure.
    /// @param numbers how many it must have.
    std::string emptied(std::size_t numbers) const;
    /// Reads the numbers in the order of the file; a missing one is NaN. @return the reason for a failure.
    std::optional<std::string> read(std::vector<double>& numbers) const;

private:
    using Owned = std::unique_ptr<codes_handle, int (*)(codes_handle*)>;

    std::string _copy;
    Owned _handle;
};

} // namespace osgTreeWind
