// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace osgTreeWind {

/// The way of values from a process to another of the same build. pass() sends a value at one end and takes
/// it in at the other; false when there is nobody there, or what comes makes no sense.
class Wire {
public:
    /// Sends a value, or what is wrong, to a file descriptor. @param pass of the members of a value.
    template <typename T>
    static bool send(int descriptor, Result<T>& result, bool (*pass)(Wire&, T&));
    /// Reads what send() wrote: nothing where it ends too early or makes no sense.
    template <typename T>
    static std::optional<Result<T>> receive(int descriptor, bool (*pass)(Wire&, T&));

    template <typename T>
    bool pass(T& value); ///< A number, or a struct of numbers.
    template <typename T>
    bool pass(std::vector<T>& values);
    bool pass(std::string& text);
    bool pass(Diagnostic& problem);

private:
    static constexpr std::size_t mostBytes = std::size_t(1) << 34;  // of one vector
    static constexpr std::size_t mostAtOnce = std::size_t(1) << 29; // bytes of memory for what may not come
    static constexpr std::size_t step = 1 << 20;                    // values

    Wire(int descriptor, bool sends) : _descriptor(descriptor), _sends(sends) {}

    bool passBytes(void* bytes, std::size_t size);

    int _descriptor;
    bool _sends;
};

template <typename T>
bool Wire::send(int descriptor, Result<T>& result, bool (*pass)(Wire&, T&)) {
    Wire wire(descriptor, true);
    unsigned char good = result.ok();
    if (good == 1)
        return wire.pass(good) && pass(wire, result.value());
    Diagnostic problem = result.problems().front();
    return wire.pass(good) && wire.pass(problem);
}

template <typename T>
std::optional<Result<T>> Wire::receive(int descriptor, bool (*pass)(Wire&, T&)) {
    Wire wire(descriptor, false);
    unsigned char good = 0;
    T value;
    Diagnostic problem;
    if (!wire.pass(good) || good > 1 || !(good == 1 ? pass(wire, value) : wire.pass(problem)))
        return std::nullopt;
    return good == 1 ? Result<T>(std::move(value)) : Result<T>(std::move(problem));
}

template <typename T>
bool Wire::pass(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    return passBytes(&value, sizeof value);
}

template <typename T>
bool Wire::pass(std::vector<T>& values) {
    std::size_t size = values.size();
    if (!pass<std::size_t>(size) || size > mostBytes / sizeof(T))
        return false;
    if constexpr (!std::is_trivially_copyable_v<T>) {
        for (std::size_t i = 0; i < size; ++i) {
            if (!_sends)
                values.emplace_back();
            if (!pass(values[i]))
                return false;
        }
        return true;
    } else {
        if (_sends)
            return passBytes(values.data(), size * sizeof(T));
        try {
            values.reserve(std::min(size, mostAtOnce / sizeof(T)));
            while (values.size() < size) {
                const std::size_t known = values.size(), some = std::min(step, size - known);
                values.resize(known + some);
                if (!passBytes(&values[known], some * sizeof(T)))
                    return false;
            }
        } catch (const std::bad_alloc&) {
            return false;
        }
        return true;
    }
}

} // namespace osgTreeWind
