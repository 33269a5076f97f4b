// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/OcclusionBuffer.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace osgTreeWind {
namespace {

/// Overlap of the cell [cell, cell + 1] with an interval.
float within(int cell, float from, float to) {
    return std::min(to, static_cast<float>(cell + 1)) - std::max(from, static_cast<float>(cell));
}

int clampToScreen(float cells, int most) {
    return static_cast<int>(std::clamp(cells, 0.0f, static_cast<float>(most)));
}

/// Row or column of a coverage grid. @param place in [0, 1).
int gridIndex(float place) {
    return std::clamp(static_cast<int>(place * ImpostorCoverage::side), 0, ImpostorCoverage::side - 1);
}

float columnAt(float x) {
    return 0.5f * OcclusionBuffer::columns * (x + 1.0f);
}
float rowAt(float y) {
    return 0.5f * OcclusionBuffer::rows * (y + 1.0f);
}

/// Calls visit(cell, row of the coverage grid, covered share) for each screen cell that a billboard touches.
template <typename Visit>
void forEachCell(const OcclusionBuffer::Billboard& billboard, Visit visit) {
    if (!billboard.coverage)
        return;
    const float bottom = rowAt(billboard.low.y()), top = rowAt(billboard.high.y());
    const float width = OcclusionBuffer::columns * billboard.halfWidth;
    const int last = clampToScreen(std::ceil(top), OcclusionBuffer::rows);
    for (int y = clampToScreen(std::floor(bottom), OcclusionBuffer::rows); y < last; ++y) {
        const float height = within(y, bottom, top);
        const float middle = std::max(bottom, static_cast<float>(y)) + 0.5f * height;
        const float up = (middle - bottom) / (top - bottom);
        const float left =
            columnAt(billboard.low.x() + up * (billboard.high.x() - billboard.low.x())) - 0.5f * width;
        const int rowPart = gridIndex(up);
        const float* const coverage = billboard.coverage->data() + rowPart * ImpostorCoverage::side;
        const int end = clampToScreen(std::ceil(left + width), OcclusionBuffer::columns);
        for (int x = clampToScreen(std::floor(left), OcclusionBuffer::columns); x < end; ++x) {
            const float across = within(x, left, left + width);
            const float place = std::max(left, static_cast<float>(x)) + 0.5f * across - left;
            visit(static_cast<std::size_t>(y * OcclusionBuffer::columns + x), rowPart,
                  height * across * coverage[gridIndex(place / width)]);
        }
    }
}

/// Calls visit(cell, overlap) for each screen cell of a rectangle.
template <typename Visit>
void forEachCell(const osg::Vec2& low, const osg::Vec2& high, Visit visit) {
    const float left = columnAt(low.x()), right = columnAt(high.x()), bottom = rowAt(low.y()),
                top = rowAt(high.y());
    const int firstColumn = clampToScreen(std::floor(left), OcclusionBuffer::columns),
              endColumn = clampToScreen(std::ceil(right), OcclusionBuffer::columns),
              endRow = clampToScreen(std::ceil(top), OcclusionBuffer::rows);
    for (int y = clampToScreen(std::floor(bottom), OcclusionBuffer::rows); y < endRow; ++y) {
        const float height = within(y, bottom, top);
        for (int x = firstColumn; x < endColumn; ++x)
            visit(static_cast<std::size_t>(y * OcclusionBuffer::columns + x),
                  height * within(x, left, right));
    }
}

bool isNegligible(float shown, float area, float most) {
    return shown <= OcclusionBuffer::negligible * area && most <= 5.0f * OcclusionBuffer::negligible;
}

} // namespace

bool OcclusionBuffer::isHidden(const Rectangle& part) const {
    float shown = 0.0f, area = 0.0f, most = 0.0f;
    forEachCell(part.low, part.high, [&](std::size_t cell, float overlap) {
        shown += overlap * _transmittance[cell];
        area += overlap;
        most = std::max(most, _transmittance[cell]);
    });
    return area > 0.0f && isNegligible(shown, area, most);
}

void OcclusionBuffer::add(const Rectangle& part) {
    forEachCell(part.coreLow, part.coreHigh, [&](std::size_t cell, float overlap) {
        _transmittance[cell] *= 1.0f - overlap * part.coverage;
    });
}

float OcclusionBuffer::visibleShare(const Billboard& billboard) const {
    std::array<float, ImpostorCoverage::side> shown{}, clear{};
    bool touched = false;
    forEachCell(billboard, [&](std::size_t cell, int part, float coverage) {
        const float shows = coverage * _transmittance[cell];
        shown[static_cast<std::size_t>(part)] += shows;
        clear[static_cast<std::size_t>(part)] += shows * _transmittance[cell];
        touched = touched || coverage > 0.0f;
    });
    if (!touched)
        return 1.0f;
    float clearest = 0.0f;
    for (std::size_t part = 0; part < shown.size(); ++part)
        if (shown[part] > 0.0f)
            clearest = std::max(clearest, clear[part] / shown[part]);
    return clearest;
}

bool OcclusionBuffer::isHidden(const Billboard& billboard) const {
    float shown = 0.0f, total = 0.0f, most = 0.0f;
    forEachCell(billboard, [&](std::size_t cell, int, float coverage) {
        shown += coverage * _transmittance[cell];
        total += coverage;
        most = std::max(most, coverage > 0.0f ? _transmittance[cell] : 0.0f);
    });
    return total > 0.0f && isNegligible(shown, total, most);
}

float OcclusionBuffer::minTransmittance(const osg::Vec2& low, const osg::Vec2& high) const {
    float least = 1.0f;
    forEachCell(low, high, [&](std::size_t cell, float) { least = std::min(least, _transmittance[cell]); });
    return least;
}

void OcclusionBuffer::add(const Billboard& billboard) {
    forEachCell(billboard,
                [&](std::size_t cell, int, float coverage) { _transmittance[cell] *= 1.0f - coverage; });
}

} // namespace osgTreeWind
