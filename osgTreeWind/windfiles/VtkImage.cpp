// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/VtkImage.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/wind/GustyWind.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace osgTreeWind {

namespace {

using Arrays = std::vector<VtkArray>;
using Indices = std::vector<std::size_t>;

/// The vectors that need no name; empty if there is a choice.
Indices usualVectors(const Arrays& arrays) {
    const bool isActiveInPoints = std::any_of(
        arrays.begin(), arrays.end(), [](const VtkArray& array) { return array.isActive && !array.ofCells; });
    const auto onlyOne = [&](const auto& isMeant) {
        Indices found;
        std::set<std::string> names;
        for (const bool ofCells : {false, true})
            for (std::size_t i = 0; i < arrays.size(); ++i)
                if (arrays[i].components == 3.0 && arrays[i].ofCells == ofCells && isMeant(arrays[i])) {
                    names.insert(arrays[i].name);
                    found = {found.empty() ? i : found.front()};
                }
        return names.size() == 1 ? found : Indices();
    };
    Indices found =
        onlyOne([&](const VtkArray& array) { return array.isActive && array.ofCells != isActiveInPoints; });
    for (const char* name : {"u", "velocity", "wind"})
        if (found.empty())
            found = onlyOne([&](const VtkArray& array) { return lower(array.name) == name; });
    return found.empty() ? onlyOne([](const VtkArray&) { return true; }) : found;
}

/// The array of 3 components with a name, or an array of one for each name; empty if one is missing.
Indices named(const Arrays& arrays, const std::vector<std::string>& names) {
    const double components = names.size() > 1 ? 1.0 : 3.0;
    for (const bool ofCells : {false, true}) {
        Indices found;
        for (const std::string& name : names)
            for (std::size_t i = 0; i < arrays.size() && found.size() < 3; ++i)
                if (arrays[i].name == name && arrays[i].ofCells == ofCells &&
                    arrays[i].components == components) {
                    found.push_back(i);
                    break;
                }
        if (found.size() == names.size())
            return found;
    }
    return {};
}

std::string problemOfChoice(const Arrays& arrays, const std::vector<std::string>& variable) {
    std::vector<std::string> found;
    for (const VtkArray& array : arrays)
        found.push_back(array.name + " (" + numberText(array.components) + ")");
    return std::string(
               variable.empty()
                   ? "expected one array of 3 components, or one that is declared active or named U, "
                     "velocity or wind"
                   : "expected the array of 3 components, or the 2 or 3 arrays of one component, that "
                     "wind.variable names") +
           "; found " + (found.empty() ? "none" : joined(found)) +
           (variable.empty() && !found.empty()
                ? "; wind.variable names the wind, or the arrays of its components"
                : "");
}

/// "point vectors 'U'", with the vectors that were not chosen.
std::string describe(const Arrays& arrays, const Indices& wind) {
    std::vector<std::string> chosen, others;
    for (const std::size_t i : wind)
        chosen.push_back(arrays[i].name.empty() ? "without a name" : arrays[i].name);
    for (const VtkArray& array : arrays)
        if (array.components == 3.0 && array.name != arrays[wind.front()].name)
            others.push_back(array.name);
    return std::string(arrays[wind.front()].ofCells ? "cell" : "point") + " vectors '" + joined(chosen) +
           "'" + (others.empty() ? "" : "; wind.variable chooses another of " + joined(others));
}

} // namespace

glm::ivec3 VtkImage::vectorCounts() const {
    return ofCells ? glm::max(points - 1, glm::ivec3(1)) : points;
}

std::string VtkImage::normalizeSpacing() {
    for (int axis = 0; axis < 3; ++axis)
        if (points[axis] == 1)
            spacing[axis] = 1.0;
        else if (!(spacing[axis] >= 1e-6))
            return "expected metres above 0 between points";
    return {};
}

double VtkImage::vectorCount() const {
    const glm::dvec3 n(vectorCounts());
    return n.x * n.y * n.z;
}

std::string readVtkWind(const std::vector<VtkArray>& arrays, const std::vector<std::string>& variable,
                        const std::function<bool(std::size_t, std::vector<float>&)>& read, VtkImage& image) {
    const std::vector<std::size_t> wind = variable.empty() ? usualVectors(arrays) : named(arrays, variable);
    if (wind.empty())
        return problemOfChoice(arrays, variable);
    image.ofCells = arrays[wind.front()].ofCells;
    image.note = describe(arrays, wind);
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        const std::string name = lower(arrays[i].name);
        if (arrays[i].ofCells == image.ofCells && arrays[i].components == 1.0 &&
            (name == "k" || name == "tke") && !read(i, image.energy))
            return {};
    }
    if (wind.size() == 1) {
        read(wind.front(), image.values);
        return {};
    }
    image.values.assign(3 * static_cast<std::size_t>(image.vectorCount()), 0.0f);
    for (std::size_t component = 0; component < wind.size(); ++component) {
        std::vector<float> values;
        if (!read(wind[component], values))
            return {};
        for (std::size_t i = 0; i < values.size(); ++i)
            image.values[3 * i + component] = values[i];
    }
    return {};
}

WindContent windFromVtk(VtkImage&& image, const std::string& format) {
    GridWind::Grid grid;
    grid.points = image.vectorCounts();
    grid.cell = image.spacing;
    grid.origin = image.origin;
    for (int axis = 0; image.ofCells && axis < 3; ++axis)
        if (image.points[axis] > 1)
            grid.origin[axis] += 0.5 * image.spacing[axis];
    for (std::size_t i = 0; i < image.levels.size(); ++i)
        if (!image.ofCells)
            grid.heights.push_back(image.levels[i]);
        else if (i > 0)
            grid.heights.push_back(0.5f * (image.levels[i - 1] + image.levels[i]));
    grid.values = std::move(image.values);
    // the energy of gusts whose deviation along the wind is 1 m/s
    const float energyOfUnit = 0.5f * glm::dot(gustDeviations, gustDeviations);
    for (const float energy : image.energy)
        grid.deviations.push_back(energy > 0.0f ? std::sqrt(energy / energyOfUnit) : 0.0f);
    if (image.time)
        grid.times = {*image.time};
    WindContent content;
    content.summary.format = format;
    content.summary.mayIncludeTrees = true;
    content.summary.direction = "components toward x, y and z, taken as east, north and up";
    content.summary.notes = {image.note};
    content.data = std::move(grid);
    return content;
}

} // namespace osgTreeWind
