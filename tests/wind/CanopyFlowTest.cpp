// SPDX-License-Identifier: MIT
#include <tests/wind/Winds.h>

#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr float height = 20.0f, shelter = 0.5f;

std::shared_ptr<const CanopyMap> stand(float frontalArea = 2.0f) {
    auto map = std::make_shared<CanopyMap>();
    map->usual.closure = closureOf(frontalArea);
    map->usual.profile = CanopyProfile::ofStand(height, frontalArea);
    map->usual.shelter.fill(shelter);
    map->isUniform = true;
    return map;
}

LayeredWind windOf(float speed, std::uint32_t seed = 1) {
    return inStand(std::make_shared<UniformWind>(glm::vec3(speed, 0.0f, 0.0f)), *stand(), height, seed);
}

/// Statistics of the wind at one height over an hour at 200 distant places.
struct Statistics {
    double count = 0.0, mean = 0.0, along = 0.0, across = 0.0, up = 0.0, third = 0.0, stress = 0.0,
           thirdUp = 0.0;

    Statistics(const WindField& wind, float z) {
        std::vector<glm::dvec3> winds;
        for (int i = 0; i < 200; ++i)
            for (int t = 0; t < 500; ++t) {
                winds.emplace_back(
                    wind.velocity(WindPlace(0.0f, 977.0f * static_cast<float>(i), z), 7.3 * t));
                mean += winds.back().x;
                ++count;
            }
        mean /= count;
        for (const glm::dvec3& v : winds) {
            const double u = v.x - mean;
            along += u * u / count;
            across += v.y * v.y / count;
            up += v.z * v.z / count;
            third += u * u * u / count;
            thirdUp += v.z * v.z * v.z / count;
            stress += u * v.z / count;
        }
    }
    double skewness() const { return third / std::pow(along, 1.5); }
};

TEST(CanopyFlow, NeighbourEffectIsThatOfTheStand) {
    auto map = std::make_shared<CanopyMap>(*stand());
    map->usual.crownCover = 0.8f;
    const auto open = std::make_shared<UniformWind>(glm::vec3(6.0f, 0.0f, 0.0f));
    const NeighbourEffect among =
        inStand(open, *map, height, 1).canopy()->neighbourEffectAt(glm::vec2(40.0f, -3.0f));
    EXPECT_EQ(among.crownCover, 0.8f);
    EXPECT_EQ(among.shelter, shelter);
    map->usual.closure = 0.5f; // half a stand shelters half as much
    EXPECT_EQ(inStand(open, *map, height, 1).canopy()->neighbourEffectAt(glm::vec2(0.0f)).shelter, 0.75f);
    const NeighbourEffect alone =
        inStand(open, CanopyMap(), height, 1).canopy()->neighbourEffectAt(glm::vec2(0.0f));
    EXPECT_EQ(alone.crownCover, 0.0f);
    EXPECT_EQ(alone.shelter, 1.0f);
}

TEST(CanopyFlow, HasTheMeanSpreadAndSkewnessOfItsProfile) {
    const LayeredWind wind = windOf(10.0f);
    const CanopyProfile profile = CanopyProfile::ofStand(height, 2.0f);
    for (const float z : {20.0f, 15.0f, 10.0f, 30.0f}) {
        const Statistics found(wind, z);
        const WindSpread spread = profile.spread(z);
        EXPECT_NEAR(found.mean / static_cast<double>(10.0f * profile.mean(z)), 1.0, 0.03) << z;
        EXPECT_NEAR(std::sqrt(found.along) / static_cast<double>(10.0f * spread.along), 1.0, 0.1) << z;
        EXPECT_NEAR(std::sqrt(found.across) / static_cast<double>(10.0f * spread.across), 1.0, 0.1) << z;
        EXPECT_NEAR(std::sqrt(found.up) / static_cast<double>(10.0f * spread.up), 1.0, 0.1) << z;
        EXPECT_NEAR(found.skewness(), static_cast<double>(profile.skewness(z)), 0.15) << z;
    }
}

Wind gusty(const glm::vec3& mean, const std::optional<LogProfile>& profile = {}) {
    Wind wind(std::make_shared<UniformWind>(mean, profile));
    wind.gusts.intensity = 0.2;
    return wind;
}

/// Gusts of this mean speed in the stand.
LayeredWind gustsOf(float speed, std::uint32_t seed = 1) {
    return inStand(gusty({speed, 0.0f, 0.0f}), *stand(), height, seed);
}

// Strains of trees in five minutes vary by 0.25 to 0.32 of their mean from one block to the next; without
// slow gusts, by 0.1.
TEST(CanopyFlow, GustsVaryOverMinutesWithTheSpreadAndSkewnessOfTheProfile) {
    const CanopyProfile profile = CanopyProfile::ofStand(height, 2.0f);
    double squares = 0.0, cubes = 0.0, slow = 0.0, blocks = 0.0;
    for (std::uint32_t seed = 1; seed <= 24; ++seed) {
        const LayeredWind wind = gustsOf(10.0f, seed);
        for (int block = 0; block < 12; ++block) {
            double sum = 0.0;
            for (int i = 0; i < 300; ++i) {
                const WindPlace top(0.0f, 0.0f, height);
                const double u = wind.velocity(top, 300.0 * block + i).x - 10.0f;
                sum += u / 300.0;
                squares += u * u / 300.0;
                cubes += u * u * u / 300.0;
            }
            slow += sum * sum;
            blocks += 1.0;
        }
    }
    EXPECT_NEAR(std::sqrt(squares / blocks) / static_cast<double>(10.0f * profile.spread(height).along), 1.0,
                0.05);
    EXPECT_NEAR(cubes / blocks / std::pow(squares / blocks, 1.5),
                static_cast<double>(profile.skewness(height)), 0.1);
    // sqrt(2.4^2 - 1.8^2) u* over the mean at 2 h; some of it averages out in five minutes
    const float above = profile.mean(2.0f * height);
    EXPECT_NEAR(std::sqrt(slow / blocks) / 10.0,
                0.85 * static_cast<double>(1.5875f * profile.friction / above), 0.03);
}

TEST(CanopyFlow, SweepsComeFromAbove) {
    const Statistics found(windOf(10.0f), height);
    EXPECT_NEAR(found.stress / -9.0, 1.0, 0.15) << "-u*^2, with u* 0.3 of 10 m/s";
    EXPECT_LT(found.thirdUp, 0.0);
}

TEST(CanopyFlow, StressIsTheSameAboveTheCanopy) {
    for (const float z : {1.5f * height, 2.0f * height, 3.0f * height}) {
        EXPECT_NEAR(Statistics(windOf(10.0f), z).stress / -9.0, 1.0, 0.05) << z;
        EXPECT_NEAR(Statistics(gustsOf(10.0f), z).stress / -9.0, 1.0, 0.05) << z;
    }
}

/// Correlation of the wind component along the mean between two places and times.
double correlation(const WindField& wind, const glm::vec3& apart, double later) {
    double product = 0.0, squares = 0.0, sum = 0.0;
    constexpr int count = 40000;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 at(0.0f, 613.0f * static_cast<float>(i % 200), height);
        const double time = 11.7 * (i / 200);
        const double a = wind.velocity(WindPlace(at), time).x - 10.0f;
        const double b = wind.velocity(WindPlace(at + apart), time + later).x - 10.0f;
        product += a * b;
        squares += a * a;
        sum += a;
    }
    return (product - sum * sum / count) / (squares - sum * sum / count);
}

TEST(CanopyFlow, GustsTravelAtNearlyTwiceTheWindAtTheTop) {
    const LayeredWind wind = windOf(10.0f);
    const double atGustSpeed = correlation(wind, {36.0f, 0.0f, 0.0f}, 2.0); // 18 m/s
    EXPECT_GT(atGustSpeed, 0.5);
    EXPECT_LT(atGustSpeed, 0.8) << "gusts change on their way";
    EXPECT_LT(correlation(wind, {36.0f, 0.0f, 0.0f}, 1.5), atGustSpeed);
    EXPECT_LT(correlation(wind, {36.0f, 0.0f, 0.0f}, 2.5), atGustSpeed);
}

TEST(CanopyFlow, TimeScaleIsTreeHeightOverSpeedAtTheTop) {
    const LayeredWind wind = windOf(10.0f);
    double scale = 0.0;
    for (double lag = 0.0; lag < 12.0; lag += 0.25)
        scale += 0.25 * std::max(correlation(wind, {}, lag), 0.0);
    EXPECT_NEAR(scale - 0.125, 2.0, 0.4) << "h / U(h), 20 m by 10 m/s";
}

TEST(CanopyFlow, GustsAreUncorrelatedAcrossTheWind) {
    const LayeredWind wind = windOf(10.0f);
    EXPECT_LT(correlation(wind, {0.0f, 20.0f, 0.0f}, 0.0), 0.4);
    EXPECT_LT(std::abs(correlation(wind, {0.0f, 60.0f, 0.0f}, 0.0)), 0.1);
}

TEST(CanopyFlow, CrownsShelterOnlyPlacesAmongLeaves) {
    const LayeredWind wind = windOf(10.0f);
    WindPlace among(0.0f, 0.0f, 15.0f), over(0.0f, 0.0f, 30.0f);
    const glm::vec3 free = wind.velocity(among, 3.0), high = wind.velocity(over, 3.0);
    among.inCrown = over.inCrown = true;
    EXPECT_NEAR(glm::length(wind.velocity(among, 3.0)) / glm::length(free), shelter, 1e-4f);
    EXPECT_EQ(wind.velocity(over, 3.0), high);
}

TEST(CanopyFlow, DependsOnlyOnPlaceTimeAndSeed) {
    const LayeredWind a = windOf(10.0f), b = windOf(10.0f), c = windOf(10.0f, 2);
    const WindPlace place(3.0f, 4.0f, 12.0f);
    EXPECT_EQ(a.velocity(place, 5.0), b.velocity(place, 5.0));
    EXPECT_NE(a.velocity(place, 5.0), c.velocity(place, 5.0));
    std::vector<WindPlace> many(150, place);
    std::vector<glm::vec3> out(many.size());
    a.sample(many.data(), many.size(), 5.0, out.data());
    for (const glm::vec3& v : out)
        EXPECT_EQ(v, a.velocity(place, 5.0));
}

TEST(CanopyFlow, IsCalmBelowACalm) {
    EXPECT_EQ(windOf(0.0f).velocity(WindPlace(1.0f, 2.0f, 3.0f), 4.0), glm::vec3(0.0f));
}

/// Trees west of x = 0, open country east of it.
std::shared_ptr<const CanopyMap> edge() {
    auto map = std::make_shared<CanopyMap>(*stand());
    map->isUniform = false;
    map->first = {-50, -50};
    map->cell = 10.0f;
    map->width = map->length = 100;
    map->cells.resize(10000);
    map->fetch = 40.0f;
    for (std::size_t i = 0; i < map->cells.size(); ++i)
        if (i % 100 > 0 && i % 100 < 50 && i / 100 > 0 && i / 100 < 99)
            map->cells[i] = map->usual;
    return map;
}

TEST(CanopyFlow, InvalidOrExcessiveWindIsCalm) {
    class Nonsense : public WindField {
    public:
        explicit Nonsense(float speed) : _speed(speed) {}
        glm::vec3 velocity(const WindPlace&, double) const override { return {_speed, 0.0f, 0.0f}; }

    private:
        float _speed;
    };
    for (const float speed : {NAN, INFINITY, 1e30f, 3e38f}) {
        const LayeredWind wind = inStand(std::make_shared<Nonsense>(speed), *stand(), height, 1);
        EXPECT_EQ(wind.velocity(WindPlace(3.0f, 4.0f, 5.0f), 7.0), glm::vec3(0.0f)) << speed;
    }
}

TEST(CanopyFlow, WhatItKeepsOfAPlaceChangesNoWind) {
    const LayeredWind winds[] = {inStand(gusty({-10.0f, 0.0f, 0.0f}), *edge(), 60.0f, 1),
                                 inStand(gusty({6.0f, 7.0f, 0.0f}), *edge(), 60.0f, 1), windOf(10.0f)};
    PlaceInStand kept;
    for (int i = 0; i < 300; ++i) { // places, winds and times in turn
        WindPlace place(2.0f * static_cast<float>(i / 9) - 60.0f, 3.0f, i % 2 == 0 ? 12.0f : 25.0f);
        place.inCrown = i % 4 < 2;
        const LayeredWind& wind = winds[i / 3 % 3];
        const glm::vec3 fresh = wind.velocity(place, 0.5 * i);
        place.stand = &kept;
        EXPECT_EQ(wind.velocity(place, 0.5 * i), fresh) << i;
        EXPECT_EQ(wind.velocity(place, 0.5 * i), fresh) << i;
    }
}

TEST(CanopyFlow, KeepsWhatItKnowsWhileTheDirectionStays) {
    // within the first CanopySpeedStep
    const LayeredWind wind = inStand(gusty({2.0f, 3.5f, 0.0f}), *stand(), height, 1);
    PlaceInStand kept;
    WindPlace place(3.0f, 4.0f, 12.0f);
    place.stand = &kept;
    wind.velocity(place, 0.0);
    const std::uint64_t key = kept.key;
    EXPECT_NE(key, 0u);
    for (int second = 1; second < 600; ++second) {
        wind.velocity(place, second);
        EXPECT_EQ(kept.key, key) << second;
    }
}

TEST(CanopyFlow, BlendsSmoothlyFromOpenCountryIntoTheStand) {
    const Wind given = gusty({-10.0f, 0.0f, 0.0f}, LogProfile{10.0, 0.05}); // from the east, toward the edge
    const WindFieldPtr open = asField(given);
    const LayeredWind wind = inStand(given, *edge(), 60.0f, 1);
    const WindPlace at(30.0f, 0.0f, 12.0f);
    EXPECT_EQ(wind.velocity(at, 9.0), open->velocity(at, 9.0));
    EXPECT_LT(glm::length(wind.velocity(WindPlace(-200.0f, 0.0f, 2.0f), 9.0)),
              0.5f * glm::length(open->velocity(at, 9.0)));
    glm::vec3 last = wind.velocity(at, 9.0);
    for (float x = 30.0f; x > -150.0f; x -= 0.02f) {
        const glm::vec3 next = wind.velocity(WindPlace(x, 0.0f, 12.0f), 9.0);
        EXPECT_LT(glm::length(next - last), 0.25f) << x;
        last = next;
    }
}

TEST(CanopyFlow, IsFiniteForAnyPlaceAndTime) {
    const LayeredWind all = inStand(std::make_shared<UniformWind>(glm::vec3(200.0f, 0.0f, 0.0f)), *stand(),
                                    60.0f, 1),
                      some = inStand(std::make_shared<UniformWind>(glm::vec3(200.0f, 0.0f, 0.0f)), *edge(),
                                     60.0f, 1);
    for (const float x : {-1e30f, -40.0f, 0.0f, 3e38f})
        for (const float z : {-1e30f, 0.0f, 20.0f, 3e38f})
            for (const double time : {-1e300, 0.0, 1e300})
                for (const WindField* wind :
                     {static_cast<const WindField*>(&all), static_cast<const WindField*>(&some)}) {
                    const glm::vec3 v = wind->velocity(WindPlace(x, x, z), time);
                    EXPECT_TRUE(std::isfinite(v.x + v.y + v.z)) << x << ' ' << z << ' ' << time;
                }
}

} // namespace
