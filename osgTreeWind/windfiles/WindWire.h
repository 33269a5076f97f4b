// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/windfiles/WindContent.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The way of a grid, or of what is wrong with it, from a process that reads it to the one that wants it;
/// both of the same build. Not part of the interface.
class WindWire {
public:
    /// Writes to a file descriptor. False when nobody takes it any more.
    static bool send(int descriptor, Result<WindContent>& content);
    /// Reads what send() wrote: nothing where it ends too early or makes no sense.
    static std::optional<Result<WindContent>> receive(int descriptor);

private:
    WindWire(int descriptor, bool sends) : _descriptor(descriptor), _sends(sends) {}

    bool pass(Diagnostic& problem);
    bool pass(WindContent& content);
    template <typename T>
    bool pass(T& number); ///< Or a vector of glm.
    template <typename T>
    bool pass(std::vector<T>& numbers);
    bool pass(std::string& text);
    bool pass(std::vector<std::string>& texts);
    bool passBytes(void* bytes, std::size_t size);

    int _descriptor;
    bool _sends;
};

} // namespace osgTreeWind
