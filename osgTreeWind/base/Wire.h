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

/// The way of values from a process to another of the same build. pass() sends a value at one end and takes
/// it in at the other; false when there is nobody there, or what comes makes no sense.
class Wire {
public:
    /// Sends a value, or what is wrong, to a file descriptor.
    template <typename T>
    static bool send(int descriptor, Result<T>& result);
    /// Reads what send() wrote: nothing where it ends too early or makes no sense.
    template <typename T>
    static std::optional<Result<T>> receive(int descriptor);

    /// One that sends values, for those who send one after another.
    static Wire sender(int descriptor) { return Wire(descriptor, true); }
    static Wire receiver(int descriptor) { return Wire(descriptor, false); }

    /// A number, a struct of numbers, or a struct whose parts() is a std::tie() of the members to pass.
    template <typename T>
    bool pass(T& value);
    bool pass(bool& value);
    template <typename First, typename Second>
    bool pass(std::pair<First, Second>& values) {
        return pass(values.first, values.second);
    }
    template <typename T>
    bool pass(std::vector<T>& values);
    template <typename T>
    bool pass(std::optional<T>& value);
    bool pass(std::string& text);
    bool pass(Diagnostic& problem);
    /// Several, one after another.
    template <typename First, typename Second, typename... More>
    bool pass(First& first, Second& second, More&... more) {
        return pass(first) && pass(second, more...);
    }

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
bool Wire::send(int descriptor, Result<T>& result) {
    Wire wire(descriptor, true);
    bool good = result.ok();
    if (good)
        return wire.pass(good) && wire.pass(result.value());
    Diagnostic problem = result.problems().front();
    return wire.pass(good) && wire.pass(problem);
}

template <typename T>
std::optional<Result<T>> Wire::receive(int descriptor) {
    Wire wire(descriptor, false);
    bool good = false;
    T value{};
    Diagnostic problem;
    if (!wire.pass(good) || !(good ? wire.pass(value) : wire.pass(problem)))
        return std::nullopt;
    return good ? Result<T>(std::move(value)) : Result<T>(std::move(problem));
}

template <typename T>
bool Wire::pass(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>)
        return passBytes(&value, sizeof value);
    else
        return std::apply([this](auto&... parts) { return this->pass(parts...); }, value.parts());
}

template <typename T>
bool Wire::pass(std::optional<T>& value) {
    bool is = value.has_value();
    if (!pass(is))
        return false;
    if (is && !_sends)
        value.emplace();
    return !is || pass(*value);
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
