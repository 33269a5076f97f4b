// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/BoughCard.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/drawing/looks/Parallelogram.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

/// A spray on the card, in widths of the card.
struct SprayPlace {
    glm::vec2 middle, up; ///< `up` from the foot toward the tip, unit length.
    std::size_t spray;
    float hand; ///< 1, or -1 for mirrored.
};

float meanAlpha(const LeafTexels& texels) {
    double sum = 0.0;
    for (const glm::vec4& texel : texels.texels)
        sum += static_cast<double>(texel.a);
    return static_cast<float>(sum / static_cast<double>(texels.texels.size()));
}

/// Rows of segments of fronds; each pair of rows shares a rib.
std::vector<SprayPlace> placesOnRibs(std::size_t sprays, int rows) {
    std::vector<SprayPlace> places;
    for (int i = 0; i < rows * rows; ++i) {
        const float up = (i / rows) % 2 == 0 ? -1.0f : 1.0f;
        places.push_back({(glm::vec2(i % rows, i / rows) + 0.5f) / static_cast<float>(rows),
                          {0.0f, up},
                          static_cast<std::size_t>(i) % sprays,
                          up});
    }
    return places;
}

/// A jittered grid of `rows` rows and columns; tips point away from the foot of the card.
std::vector<SprayPlace> scatteredPlaces(std::size_t sprays, int rows, int enlargement, int variant) {
    Random random(17 + static_cast<std::uint64_t>(100 * enlargement + variant));
    std::vector<SprayPlace> places;
    const float edge = 0.4f / static_cast<float>(enlargement);
    for (int i = 0; i < rows * rows; ++i) {
        const glm::vec2 jitter{random.symmetric(), random.symmetric()};
        const glm::vec2 place =
            (glm::vec2(i % rows, i / rows) + 0.5f + 0.5f * jitter) / static_cast<float>(rows);
        const glm::vec2 middle = glm::clamp(place, edge, 1.0f - edge);
        const glm::vec2 away = glm::normalize(middle - glm::vec2(0.5f, -0.4f));
        const float lean = math::atan2(away.x, away.y) + 1.3f * random.symmetric();
        places.push_back({middle,
                          {math::sin(lean), math::cos(lean)},
                          static_cast<std::size_t>(random.next() % sprays),
                          random.uniform() < 0.5f ? -1.0f : 1.0f});
    }
    return places;
}

void paint(const LeafTexels& spray, const SprayPlace& place, float size, LeafTexels& card) {
    const auto texels = static_cast<float>(card.size), sprayTexels = static_cast<float>(spray.size);
    const glm::vec2 right{place.up.y, -place.up.x};
    constexpr float reach = 1.01f; // so that rounding leaves out no texel
    const glm::vec2 across = reach * texels * size * right, along = reach * texels * size * place.up;
    visitParallelogram(
        texels * place.middle - 0.5f * (across + along), across, along, 1, card.size, [&](const auto& row) {
            for (int x = row.first; x < row.end; ++x) {
                const glm::vec2 away = ((glm::vec2(x, row.y) + 0.5f) / texels - place.middle) / size;
                const glm::vec2 at{place.hand * glm::dot(away, right) + 0.5f,
                                   glm::dot(away, place.up) + 0.5f};
                const glm::vec2 texel = at * sprayTexels;
                if (glm::min(texel.x, texel.y) < 0.0f || glm::max(texel.x, texel.y) >= sprayTexels)
                    continue;
                const glm::vec4& over = spray.at(static_cast<int>(texel.x), static_cast<int>(texel.y));
                if (over.a == 0.0f)
                    continue;
                glm::vec4& under = card.at(x, row.y);
                const float left = under.a * (1.0f - over.a), whole = over.a + left;
                under = {glm::mix(glm::vec2(under), glm::vec2(over), over.a / whole),
                         glm::max(under.b, over.b), whole};
            }
        });
}

} // namespace

LeafTexels paintBough(const std::vector<LeafTexels>& sparse, const LeafTexels& full, int enlargement,
                      int variant, bool onRibs) {
    std::vector<LeafTexels> small; // with texels about as large as those of the card
    for (LeafTexels spray : sparse) {
        for (int shrunk = enlargement; shrunk > 1; shrunk /= 2)
            spray = halved(spray);
        small.push_back(std::move(spray));
    }
    const float wanted = meanAlpha(full), each = glm::max(meanAlpha(sparse.front()), 0.01f);
    const int rows =
        static_cast<int>(std::lround(static_cast<float>(enlargement) * std::sqrt(wanted / each)));
    const std::vector<SprayPlace> places = onRibs
                                               ? placesOnRibs(sparse.size(), rows)
                                               : scatteredPlaces(sparse.size(), rows, enlargement, variant);
    float size = 1.0f / static_cast<float>(enlargement);
    for (int step = 0;; ++step) {
        LeafTexels card(full.size);
        for (glm::vec4& texel : card.texels)
            texel = {0.75f, 0.5f, 0.0f, 0.0f};
        for (const SprayPlace& place : places)
            paint(small[place.spray], place, size, card);
        if (step == 2)
            return halved(card);
        size *= std::sqrt(wanted / glm::max(meanAlpha(card), 0.01f));
    }
}

} // namespace osgTreeWind
