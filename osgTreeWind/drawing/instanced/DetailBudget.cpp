// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/DetailBudget.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

// Frames differ, and what trees cost jumps from tier to tier. Between these shares of the budget nothing
// changes, so that nothing goes to and fro.
constexpr double enough = 0.75, most = 1.0, aim = 0.9;
constexpr double fastestDown = 0.85, fastestUp = 1.03; // a frame
constexpr unsigned patience = 8; // frames for which a measure is awaited; a GPU's comes some frames late

} // namespace

float DetailBudget::follow(const osg::Stats& measured, unsigned frame, float milliseconds) {
    if (_asked && frame - *_asked < patience) {
        double cull = 0.0, draw = 0.0, gpu = 0.0;
        if (!measured.getAttribute(*_asked, "Cull traversal time taken", cull) ||
            !measured.getAttribute(*_asked, "Draw traversal time taken", draw))
            return _detail;
        if (!measured.getAttribute(*_asked, "GPU draw time taken", gpu) && measured.collectStats("gpu"))
            return _detail;
        judge(1000.0 * std::max(cull + draw, gpu) / static_cast<double>(milliseconds));
    }
    _asked = frame;
    return _detail;
}

void DetailBudget::judge(double shareOfBudget) {
    if (shareOfBudget > enough && shareOfBudget <= most)
        return;
    const double step = std::clamp(std::sqrt(aim / shareOfBudget), fastestDown, fastestUp);
    _detail = std::clamp(_detail * static_cast<float>(step), least, 1.0f);
}

} // namespace osgTreeWind
