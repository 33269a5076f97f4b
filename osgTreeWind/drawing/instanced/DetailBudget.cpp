// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/DetailBudget.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

// Detail stays the same between the low and the high share of the budget. This prevents oscillation: frame
// times vary, and the cost of a tree jumps between tiers.
constexpr double lowShare = 0.75, highShare = 1.0, targetShare = 0.9;
constexpr double maxDecrease = 0.85, maxIncrease = 1.03; // factors per frame
constexpr unsigned maxWait = 8;                          // frames; GPU measurements arrive some frames late

} // namespace

float DetailBudget::updateDetail(const osg::Stats& measured, unsigned frame, float milliseconds) {
    if (_pendingFrame && frame - *_pendingFrame < maxWait) {
        double cull = 0.0, draw = 0.0, gpu = 0.0;
        if (!measured.getAttribute(*_pendingFrame, "Cull traversal time taken", cull) ||
            !measured.getAttribute(*_pendingFrame, "Draw traversal time taken", draw))
            return _detail;
        if (!measured.getAttribute(*_pendingFrame, "GPU draw time taken", gpu) &&
            measured.collectStats("gpu"))
            return _detail;
        adjustDetail(1000.0 * std::max(cull + draw, gpu) / static_cast<double>(milliseconds));
    }
    _pendingFrame = frame;
    return _detail;
}

void DetailBudget::adjustDetail(double shareOfBudget) {
    if (shareOfBudget > lowShare && shareOfBudget <= highShare)
        return;
    const double step = std::clamp(std::sqrt(targetShare / shareOfBudget), maxDecrease, maxIncrease);
    _detail = std::clamp(_detail * static_cast<float>(step), minDetail, 1.0f);
}

} // namespace osgTreeWind
