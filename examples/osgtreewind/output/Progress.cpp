// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/Progress.h>

#include <osgTreeWind/system/Descriptor.h>

#include <iostream>

Progress::Progress(std::string what, std::size_t total)
    : _what(std::move(what)), _total(total), _terminal(osgTreeWind::isErrorSeen()) {}

Progress::~Progress() {
    if (_visible)
        std::cerr << '\n';
}

void Progress::advance() {
    ++_done;
    const Clock::time_point now = Clock::now();
    const bool due = now - _shown > std::chrono::milliseconds(200) || _done == _total;
    if (!_terminal || !due || now - _start < std::chrono::seconds(1))
        return;
    constexpr std::size_t width = 40;
    const std::size_t filled = width * _done / _total;
    std::cerr << '\r' << _what << " [" << std::string(filled, '#') << std::string(width - filled, ' ') << "] "
              << _done << '/' << _total << std::flush;
    _shown = now;
    _visible = true;
}
