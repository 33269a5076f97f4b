// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindWire.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <type_traits>

#include <unistd.h>

namespace osgTreeWind {

namespace {

constexpr std::size_t mostBytes = std::size_t(1) << 34; // of one row
constexpr std::size_t step = 1 << 20;                   // numbers at once: no memory for what does not come

} // namespace

bool WindWire::send(int descriptor, Result<WindContent>& content) {
    WindWire wire(descriptor, true);
    bool good = content.ok();
    if (good)
        return wire.pass(good) && wire.pass(content.value());
    Diagnostic problem = content.problems().front();
    return wire.pass(good) && wire.pass(problem);
}

std::optional<Result<WindContent>> WindWire::receive(int descriptor) {
    WindWire wire(descriptor, false);
    bool good = false;
    WindContent content;
    Diagnostic problem;
    if (!wire.pass(good) || !(good ? wire.pass(content) : wire.pass(problem)))
        return std::nullopt;
    return good ? Result<WindContent>(std::move(content)) : Result<WindContent>(std::move(problem));
}

bool WindWire::pass(Diagnostic& problem) {
    return pass(problem.file) && pass(problem.key) && pass(problem.message);
}

bool WindWire::pass(WindContent& content) {
    WindSummary& summary = content.summary;
    auto& grid = std::get<GridWind::Grid>(content.data);
    return pass(summary.format) && pass(summary.unit) && pass(summary.direction) &&
           pass(summary.coordinates) && pass(summary.start) && pass(summary.notes) && pass(grid.points) &&
           pass(grid.origin) && pass(grid.cell) && pass(grid.times) && pass(grid.heights) &&
           pass(grid.values);
}

template <typename T>
bool WindWire::pass(T& number) {
    static_assert(std::is_trivially_copyable_v<T>);
    return passBytes(&number, sizeof number);
}

template <typename T>
bool WindWire::pass(std::vector<T>& numbers) {
    std::size_t size = numbers.size();
    if (!pass<std::size_t>(size) || size > mostBytes / sizeof(T))
        return false;
    if (_sends)
        return passBytes(numbers.data(), size * sizeof(T));
    try {
        numbers.reserve(size);
    } catch (const std::bad_alloc&) {
        return false;
    }
    while (numbers.size() < size) {
        const std::size_t known = numbers.size(), some = std::min(step, size - known);
        numbers.resize(known + some);
        if (!passBytes(&numbers[known], some * sizeof(T)))
            return false;
    }
    return true;
}

bool WindWire::pass(std::string& text) {
    std::vector<char> letters(text.begin(), text.end());
    const bool good = pass(letters);
    text.assign(letters.begin(), letters.end());
    return good;
}

bool WindWire::pass(std::vector<std::string>& texts) {
    std::size_t size = texts.size();
    if (!pass<std::size_t>(size))
        return false;
    for (std::size_t i = 0; i < size; ++i) {
        if (!_sends)
            texts.emplace_back();
        if (!pass(texts[i]))
            return false;
    }
    return true;
}

bool WindWire::passBytes(void* bytes, std::size_t size) {
    auto* at = static_cast<char*>(bytes);
    while (size > 0) {
        const ssize_t passed = _sends ? write(_descriptor, at, size) : read(_descriptor, at, size);
        if (passed < 0 && errno == EINTR)
            continue;
        if (passed <= 0)
            return false;
        at += passed;
        size -= static_cast<std::size_t>(passed);
    }
    return true;
}

} // namespace osgTreeWind
