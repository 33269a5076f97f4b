// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/FrontToBack.h>

#include <algorithm>

namespace osgTreeWind {

void FrontToBack::clear() {
    for (std::vector<Tree>& trees : _waiting)
        trees.clear();
    _step = 0;
    _pictures.clear();
    _pending.clear();
    _cover.clear();
}

std::size_t FrontToBack::stepOf(float distance) {
    constexpr float depth = 6.0f; // metres
    constexpr float last = std::tuple_size_v<decltype(_waiting)> - 1;
    return static_cast<std::size_t>(std::clamp(distance / depth, 0.0f, last));
}

void FrontToBack::finishStep() {
    for (const ScreenCover::Picture& picture : _pending)
        _cover.add(picture);
    _pending.swap(_pictures);
    _pictures.clear();
}

} // namespace osgTreeWind
