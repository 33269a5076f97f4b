// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/pictures/TreeMap.h>

#include <examples/osgtreewind/pictures/Drawing.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace {

using Align = Drawing::Align;

constexpr glm::dvec2 pictureSize(1000.0, 800.0), mapCorner(30.0, 60.0), mapSize(800.0, 690.0);
constexpr glm::vec3 outline(0.6f);

/// Red to blue, distinct to colour-blind eyes (RdYlBu of ColorBrewer, Brewer 1994).
glm::vec3 colourOf(double share) {
    static const glm::vec3 colours[] = {{0.843f, 0.098f, 0.110f},
                                        {0.992f, 0.682f, 0.380f},
                                        {1.000f, 1.000f, 0.749f},
                                        {0.671f, 0.851f, 0.914f},
                                        {0.173f, 0.482f, 0.714f}};
    const double place = 4.0 * glm::clamp(share, 0.0, 1.0);
    const auto index = std::min(static_cast<std::size_t>(place), std::size_t(3));
    return glm::mix(colours[index], colours[index + 1],
                    static_cast<float>(place) - static_cast<float>(index));
}

/// The range of the middle 96 % of the values, extended to round numbers.
struct ValueRange {
    double low = 0.0, high = 1.0;
    std::vector<double> ticks;

    explicit ValueRange(const std::vector<MapTree>& trees) {
        std::vector<double> values;
        for (const MapTree& tree : trees)
            if (tree.value)
                values.push_back(*tree.value);
        if (values.empty())
            return;
        std::sort(values.begin(), values.end());
        const auto quantile = [&](double share) {
            return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
        };
        low = quantile(0.02);
        high = std::max(quantile(0.98), low + 1e-3 * std::abs(low) + 1e-6);
        const std::vector<double> inner = ticksOf(low, high, 6);
        const double step = inner.size() > 1 ? inner[1] - inner[0] : high - low;
        low = step * std::floor(low / step + 1e-9);
        high = step * std::ceil(high / step - 1e-9);
        ticks = ticksOf(low, high, 8);
    }
    double share(double value) const { return (value - low) / (high - low); }
};

/// From metres to pixels.
class MapFrame {
public:
    explicit MapFrame(const std::vector<MapTree>& trees) {
        glm::dvec2 low(1e30), high(-1e30);
        for (const MapTree& tree : trees) {
            low = glm::min(low, tree.place - tree.radius);
            high = glm::max(high, tree.place + tree.radius);
        }
        const glm::dvec2 extent = glm::max(high - low, 1.0);
        scale = std::min(mapSize.x / extent.x, mapSize.y / extent.y);
        _middle = 0.5 * (low + high);
    }
    glm::dvec2 at(const glm::dvec2& place) const {
        const glm::dvec2 off = (place - _middle) * scale;
        return mapCorner + 0.5 * mapSize + glm::dvec2(off.x, -off.y);
    }

    double scale = 1.0; ///< Pixels per metre.

private:
    glm::dvec2 _middle{0.0};
};

void drawLegend(Drawing& drawing, const ValueRange& range, const std::string& quantity) {
    constexpr glm::dvec2 corner(880.0, 120.0), bar(22.0, 420.0);
    constexpr int strips = 210;
    const auto heightOf = [&](double value) { return corner.y + bar.y * (1.0 - range.share(value)); };
    for (int i = 0; i < strips; ++i) {
        drawing.setColour(colourOf((i + 0.5) / strips));
        drawing.fillRectangle({corner.x, corner.y + bar.y * (1.0 - (i + 1.0) / strips)},
                              {bar.x, bar.y / strips + 0.5});
    }
    drawing.setColour(Drawing::black);
    for (const double tick : range.ticks) {
        drawing.drawLine({{corner.x + bar.x, heightOf(tick)}, {corner.x + bar.x + 5.0, heightOf(tick)}});
        drawing.write(tickText(tick), {corner.x + bar.x + 10.0, heightOf(tick)}, Align::Left);
    }
    drawing.write(quantity, {corner.x - 14.0, corner.y + 0.5 * bar.y}, Align::Centre, 13.0, true);
    drawing.setColour(outline);
    drawing.drawCircle({corner.x + 0.5 * bar.x, corner.y + bar.y + 34.0}, 8.0);
    drawing.setColour(Drawing::black);
    drawing.write("unknown", {corner.x + bar.x + 10.0, corner.y + bar.y + 34.0}, Align::Left);
}

void drawScale(Drawing& drawing, const MapFrame& frame) {
    const double metres = ticksOf(0.0, 200.0 / frame.scale, 3).back();
    const glm::dvec2 left(mapCorner.x, pictureSize.y - 24.0), right(left.x + metres * frame.scale, left.y);
    drawing.setColour(Drawing::black);
    drawing.drawLine({left, right}, 2.0);
    for (const glm::dvec2& end : {left, right})
        drawing.drawLine({{end.x, end.y - 5.0}, {end.x, end.y + 5.0}}, 2.0);
    drawing.write(tickText(metres) + " m", {right.x + 10.0, right.y}, Align::Left);
    const glm::dvec2 tip(891.0, 660.0);
    drawing.drawLine({{tip.x, tip.y + 50.0}, tip}, 2.0);
    drawing.drawLine({{tip.x - 6.0, tip.y + 12.0}, tip, {tip.x + 6.0, tip.y + 12.0}}, 2.0);
    drawing.write("N", {tip.x, tip.y - 12.0}, Align::Centre);
}

} // namespace

void drawTreeMap(const std::vector<MapTree>& trees, const std::string& title, const std::string& quantity,
                 const std::string& path) {
    Drawing drawing(path, pictureSize);
    const ValueRange range(trees);
    const MapFrame frame(trees);
    std::vector<const MapTree*> order;
    for (const MapTree& tree : trees)
        order.push_back(&tree);
    std::stable_sort(order.begin(), order.end(), [](const MapTree* a, const MapTree* b) {
        return a->value.value_or(1e30) > b->value.value_or(1e30);
    });
    for (const MapTree* tree : order) {
        const double radius = std::max(tree->radius * frame.scale, 2.0);
        if (tree->value) {
            drawing.setColour(colourOf(range.share(*tree->value)));
            drawing.fillCircle(frame.at(tree->place), radius);
        }
        drawing.setColour(outline);
        drawing.drawCircle(frame.at(tree->place), radius);
    }
    drawing.setColour(Drawing::black);
    drawing.write(title, {mapCorner.x, 30.0}, Align::Left, 18.0);
    drawLegend(drawing, range, quantity);
    drawScale(drawing, frame);
    drawing.finish();
}
