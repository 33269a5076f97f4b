// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/model/TreeKeys.h>
#include <osgTreeWind/species/SpeciesKeys.h>
#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/ThesisWind.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindKeys.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace osgTreeWind {

/// Generates random descriptions and documents from the tables of keys. Their trees are tiny.
class RandomForest {
public:
    explicit RandomForest(std::uint64_t seed) : _random(seed) {}

    ForestDescription description() {
        ForestDescription forest;
        fill(forest);
        forest.damage = forest.damage && forest.law == MotionLaw::Modal;
        fill(forest.drawing);
        forest.drawing.reduced = std::clamp(forest.drawing.reduced, 2e-3f, 5e4f);
        forest.drawing.full = std::max(forest.drawing.full, std::nextafter(forest.drawing.reduced, 1e5f));
        forest.drawing.impostor = 0.3f * forest.drawing.reduced;
        if (maybe())
            forest.noiseExponent = static_cast<float>(number(noiseExponents));
        forest.season = static_cast<float>(number(seasons));
        forest.step = number(frameSteps);
        forest.origin = place(maybe() ? 1e7 : 0.0);
        forest.crs = maybe() ? "EPSG:25832" : "";
        for (int i = 0, count = whole(1, 3); i < count; ++i)
            forest.species.push_back(species(std::to_string(i) + text()));
        for (int i = 0, count = whole(0, 4); i < count; ++i)
            forest.trees.push_back(tree(forest, i));
        forest.wind = wind();
        fill(forest.canopy);
        forest.wind.frame = static_cast<WindFrame>(whole(0, 2));
        if (forest.wind.field && maybe(0.3))
            forest.wind.clock = {number(within(-1e12, 1e12)), number(within(-1e6, 1e6))};
        if (forest.wind.field && maybe(0.3))
            fill(forest.wind.adjustment);
        if (forest.wind.field && maybe())
            fill(forest.wind.gusts);
        if (maybe(0.3)) {
            std::vector<WindSource> sources(static_cast<std::size_t>(whole(1, 3)));
            for (WindSource& source : sources)
                fill(source);
            forest.wind.sources = std::move(sources);
        }
        return forest;
    }

    /// A random document with some keys, in decimals of any length, and at least one tree.
    std::string document() {
        std::string text =
            "version = 1\nseed = " + std::to_string(whole(0, 9)) + "\nseason = " + decimal(seasons) + '\n';
        text += "[motion]\n" + keys<ForestDescription>({"damage"});
        if (maybe())
            text += "noise = \"1/f\"\nnoise_exponent = " + decimal(noiseExponents) + '\n';
        text += "[wind]\nkind = \"gusts\"\nspeed = " + decimal(within(0, 199)) +
                "\nunit = \"kn\"\ndirection_from = " + decimal(within(-360, 360)) + '\n' + keys<WindGusts>() +
                keys<WindClock>();
        text.replace(text.find("\"kn\""), 4, maybe() ? "\"km/h\"" : "\"m/s\"");
        for (const char* name : {"ash", "Bush"}) {
            text += std::string("[[species]]\nname = \"") + name + "\"\nshapes = 2\n[species.appearance]\n" +
                    keys<Appearance>() + "[species.wood]\n" + keys<WoodParameters>() + "[species.height]\n" +
                    keys<HeightAllometry>() + "[species.crown]\n" + keys<CrownAllometry>() +
                    "[species.branch]\n" + keys<BranchParameters>() + "[species.leaf]\n" +
                    keys<LeafMotion>() + "[species.leaves]\n" +
                    keys<LeafParameters>({"clusters", "clusters_per_branch"}) + "clusters = 5\n";
            if (maybe())
                text += "[species.tree]\nlevels = 1\nrings_per_branch = 2\nradius = 0.001\n" +
                        keys<RecursiveTreeParameters>(
                            {"levels", "children_per_branch", "rings_per_branch", "radius"});
            else
                text += "[species.palm]\ntrunk = 1\ntrunk_diameter = 0.01\nfronds = 3\n" +
                        keys<PalmParameters>({"trunk", "trunk_diameter", "fronds"});
        }
        for (int i = 0, count = whole(1, 3); i < count; ++i)
            text += "[[tree]]\nspecies = \"bush\"\nposition = [" + decimal(within(-1e4, 1e4)) + ", 2]\n" +
                    keys<TreePlacement>({"id"});
        return text;
    }

private:
    bool maybe(double share = 0.5) { return static_cast<double>(_random.uniform()) < share; }
    int whole(int low, int high) {
        return low + static_cast<int>(_random.next() % static_cast<std::uint64_t>(high - low + 1));
    }
    /// A number in the range, often one of its limits or a small one.
    double number(const Range& range) {
        const double share = 0x1p-53 * static_cast<double>(_random.next() >> 11);
        const double any = range.min + (range.max - range.min) * share;
        const double small = std::pow(10.0, -12.0 * share);
        const double value = maybe(0.1) ? range.max : maybe(0.1) ? range.min : maybe(0.1) ? small : any;
        return range.contains(value) ? value : any;
    }
    std::string decimal(const Range& range) {
        for (;;) {
            char text[40];
            std::snprintf(text, sizeof text, "%.*g", whole(1, 17), number(range));
            if (range.contains(std::stod(text)))
                return text;
        }
    }
    std::string text() {
        const char* const parts[] = {"oak", " ",          "\"", "\\", "\n", "\x01", "\x7f",
                                     "é",   "\U0001f333", "#",  "[[", "=",  "'"};
        std::string result = "a";
        for (int i = 0, count = whole(0, 6); i < count; ++i)
            result += parts[whole(0, 12)];
        return result;
    }
    glm::dvec3 place(double reach) {
        const Range range = within(-reach, reach);
        return {number(range), number(range), number(range)};
    }

    struct Fill {
        RandomForest& forest;
        const Key& key;
        void operator()(bool* value) const { *value = forest.maybe(); }
        template <typename U>
        void operator()(std::optional<U>* value) const {
            if (forest.maybe())
                (*this)(&value->emplace());
        }
        void operator()(int* value) const {
            *value = forest.whole(static_cast<int>(key.range.min), static_cast<int>(key.range.max));
        }
        void operator()(std::uint32_t* value) const {
            *value = static_cast<std::uint32_t>(forest._random.next());
        }
        void operator()(float* value) const {
            const Range range = memberRange(key);
            do
                *value = static_cast<float>(forest.number(range));
            while (!range.contains(static_cast<double>(*value)));
        }
        void operator()(double* value) const { *value = forest.number(key.range); }
        void operator()(std::array<float, 4>* values) const {
            for (float& value : *values)
                (*this)(&value);
        }
        void operator()(glm::vec3* value) const {
            for (int i = 0; i < 3; ++i)
                (*value)[i] = static_cast<float>(forest.number(key.range));
        }
        void operator()(std::string* value) const { *value = key.unit == "file" ? "" : forest.text(); }
        void operator()(std::vector<std::string>* texts) const {
            for (int i = forest.whole(0, 2); i > 0; --i)
                texts->push_back(std::to_string(forest._random.next()) + forest.text());
        }
        template <typename T>
        void operator()(T*) const {} // wind() makes arrays
        void operator()(const EnumMember& word) const {
            word.set(
                word.object,
                key.words[static_cast<std::size_t>(forest.whole(0, static_cast<int>(key.words.size()) - 1))]
                    .second);
        }
        void operator()(const NestedMember& part) const { forest.fillAll(*part.keys, part.object); }
    };
    void fillAll(const Keys& keys, void* owner) {
        for (const Key& key : keys)
            if (maybe(0.8))
                std::visit(Fill{*this, key}, key.member(owner));
    }
    template <typename Struct>
    void fill(Struct& value) {
        fillAll(keysOf<Struct>(), &value);
    }

    /// Lines of a file for some keys of a table.
    template <typename Struct>
    std::string keys(const std::vector<std::string>& without = {}) {
        std::string lines;
        for (const Key& key : keysOf<Struct>()) {
            Struct value{};
            if (std::find(without.begin(), without.end(), key.name) != without.end() || maybe(0.3))
                continue;
            const Member member = key.of(&value);
            if (std::holds_alternative<float*>(member) || std::holds_alternative<double*>(member)) {
                lines += std::string(key.name) + " = " + decimal(key.range) + '\n';
            } else if (!std::holds_alternative<NestedMember>(member)) {
                std::visit(Fill{*this, key}, member);
                std::ostringstream line;
                writeKeys(line, "", {key}, &value, nullptr);
                lines += line.str();
            }
        }
        return lines;
    }

    Species species(const std::string& name) {
        Species species;
        fill(species);
        species.name = name;
        species.shapes = whole(1, 3);
        RecursiveTreeParameters& wood = species.tree.wood;
        fill(wood);
        fill(species.tree.leaves);
        wood.levels = whole(0, 2), wood.childrenPerBranch = whole(1, 2);
        wood.radius = std::min(wood.radius, 0.49f * wood.length * static_cast<float>(wood.trunkUnits));
        species.tree.leaves.clustersPerBranch = whole(0, 2), species.tree.leaves.clusters = whole(0, 9);
        if (maybe()) {
            PalmParameters& palm = species.tree.palm.emplace();
            fill(palm);
            palm.trunk = std::max(palm.trunk, palm.crownBase);
            palm.trunkDiameter = std::min(palm.trunkDiameter, 0.49f * palm.height * palm.trunk);
            palm.fronds = whole(0, 3);
        }
        return species;
    }

    TreePlacement tree(const ForestDescription& forest, int index) {
        TreePlacement tree;
        fill(tree);
        tree.species = static_cast<std::size_t>(whole(0, static_cast<int>(forest.species.size()) - 1));
        tree.position = forest.origin + place(1000.0);
        tree.name = maybe() ? std::to_string(index) + text() : "";
        return tree;
    }

    std::vector<double> times(int count) {
        std::vector<double> times = {number(within(-1e6, 1e6))};
        for (int i = 1; i < count; ++i)
            times.push_back(std::nextafter(times.back(), 1e9) + (maybe() ? 0.0 : number(within(0, 100))));
        return times;
    }
    std::vector<float> speeds(int count) {
        std::vector<float> speeds;
        for (int i = 0; i < count; ++i)
            speeds.push_back(static_cast<float>(number(windSpeeds)));
        return speeds;
    }
    glm::vec3 velocity() {
        const std::vector<float> v = speeds(3);
        return {v[0], v[1], v[2]};
    }
    std::optional<LogProfile> profile() {
        if (maybe())
            return {};
        const double height = number(above(0.001, 10000));
        return LogProfile{height, std::min(100.0, height * number(within(0.001, 0.99)))};
    }
    WindFieldPtr wind() {
        switch (whole(0, 5)) {
        case 0:
            return nullptr;
        case 1:
            return std::make_shared<UniformWind>(velocity());
        case 2:
            return std::make_shared<UniformWind>(velocity(), profile());
        case 3: {
            GridWind::Grid grid;
            grid.points = {whole(1, 3), whole(1, 3), whole(1, 2)};
            grid.origin = place(1e6);
            grid.cell = {number(above(0, 1e6)), number(above(0, 1e6)), 1e-9};
            const int steps = whole(0, 2), points = grid.points.x * grid.points.y * grid.points.z;
            if (steps > 0)
                grid.times = times(steps);
            for (int i = 0; i < grid.points.z && maybe(0.8); ++i)
                grid.heights.push_back(0.1f + static_cast<float>(i));
            if (static_cast<int>(grid.heights.size()) < grid.points.z)
                grid.heights.clear();
            grid.aboveGround = maybe(0.5);
            if (grid.aboveGround && !grid.heights.empty() && maybe(0.5))
                grid.roughness = 0.05;
            grid.values = speeds(3 * points * std::max(1, steps));
            for (std::size_t i = 0; i < grid.values.size() / 3 && grid.points.x > 1; ++i)
                grid.deviations.push_back(std::abs(grid.values[3 * i]));
            return GridWind::create(grid).value();
        }
        case 4:
            return GridWind::fromForestWind(2, 3, speeds(18), place(1e5)).value();
        default: {
            WindSeries series;
            series.times = times(whole(1, 4));
            for (std::size_t i = 0; i < series.times.size(); ++i)
                series.velocities.push_back(velocity());
            series.repeat = maybe();
            series.profile = profile();
            return TimeSeriesWind::create(series).value();
        }
        }
    }

    Random _random;
};

} // namespace osgTreeWind
