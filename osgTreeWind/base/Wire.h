// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// Serializes values between two processes of the same build over a file descriptor. transfer() writes the
/// value on a sender and reads it on a receiver. It returns false for a closed connection or invalid data.
class Wire {
public:
    /// Sends a value, or the first problem of an error.
    template <typename T>
    static bool send(int descriptor, Result<T>& result);
    /// Receives what send() sent; empty if the data is incomplete or invalid.
    template <typename T>
    static std::optional<Result<T>> receive(int descriptor);

    static Wire sender(int descriptor) { return Wire(descriptor, true); }
    static Wire receiver(int descriptor) { return Wire(descriptor, false); }

    /// A number, a struct of numbers, or a struct whose parts() is a std::tie() of the members to transfer.
    template <typename T>
    bool transfer(T& value);
    bool transfer(bool& value);
    template <typename First, typename Second>
    bool transfer(std::pair<First, Second>& values) {
        return transfer(values.first, values.second);
    }
    template <typename T>
    bool transfer(std::vector<T>& values);
    template <typename T>
    bool transfer(std::optional<T>& value);
    bool transfer(std::string& text);
    bool transfer(Diagnostic& problem);
    /// Several values in turn.
    template <typename First, typename Second, typename... More>
    bool transfer(First& first, Second& second, More&... more) {
        return transfer(first) && transfer(second, more...);
    }

private:
    static constexpr std::size_t maxVectorBytes = std::size_t(1) << 34;
    static constexpr std::size_t maxReservedBytes = std::size_t(1) << 29; // before the data has arrived
    static constexpr std::size_t valuesPerRead = 1 << 20;

    Wire(int descriptor, bool sends) : _descriptor(descriptor), _sends(sends) {}

    bool transferBytes(void* bytes, std::size_t size);

    int _descriptor;
    bool _sends;
};

template <typename T>
bool Wire::send(int descriptor, Result<T>& result) {
    Wire wire(descriptor, true);
    bool good = result.ok();
    if (good)
        return wire.transfer(good) && wire.transfer(result.value());
    Diagnostic problem = result.problems().front();
    return wire.transfer(good) && wire.transfer(problem);
}

template <typename T>
std::optional<Result<T>> Wire::receive(int descriptor) {
    Wire wire(descriptor, false);
    bool good = false;
    T value{};
    Diagnostic problem;
    if (!wire.transfer(good) || !(good ? wire.transfer(value) : wire.transfer(problem)))
        return std::nullopt;
    return good ? Result<T>(std::move(value)) : Result<T>(std::move(problem));
}

template <typename T>
bool Wire::transfer(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>)
        return transferBytes(&value, sizeof value);
    else
        return std::apply([this](auto&... parts) { return this->transfer(parts...); }, value.parts());
}

template <typename T>
bool Wire::transfer(std::optional<T>& value) {
    bool hasValue = value.has_value();
    if (!transfer(hasValue))
        return false;
    if (hasValue && !_sends)
        value.emplace();
    return !hasValue || transfer(*value);
}

template <typename T>
bool Wire::transfer(std::vector<T>& values) {
    std::size_t size = values.size();
    if (!transfer<std::size_t>(size) || size > maxVectorBytes / sizeof(T))
        return false;
    if constexpr (!std::is_trivially_copyable_v<T>) {
        for (std::size_t i = 0; i < size; ++i) {
            if (!_sends)
                values.emplace_back();
            if (!transfer(values[i]))
                return false;
        }
        return true;
    } else {
        if (_sends)
            return transferBytes(values.data(), size * sizeof(T));
        try {
            values.reserve(std::min(size, maxReservedBytes / sizeof(T)));
            while (values.size() < size) {
                const std::size_t done = values.size(), count = std::min(valuesPerRead, size - done);
                values.resize(done + count);
                if (!transferBytes(&values[done], count * sizeof(T)))
                    return false;
            }
        } catch (const std::bad_alloc&) {
            return false;
        }
        return true;
    }
}

} // namespace osgTreeWind
