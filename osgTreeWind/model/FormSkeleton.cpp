// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/FormSkeleton.h>

#include <osgTreeWind/model/AxesSkeleton.h>
#include <osgTreeWind/model/WoodVolume.h>

#include <glm/geometric.hpp>

#include <map>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr std::size_t maxUnits = 250;

std::vector<WoodAxis> axesOf(const GrownForm& form) {
    struct Place {
        std::size_t axis;
        double along; ///< Arc length on the axis, metres.
    };
    std::vector<WoodAxis> axes(1);
    axes.front().line.add(glm::dvec3(0.0));
    axes.front().leafy = {0.0, 0.0};
    std::vector<Place> places(form.metamers.size(), Place{0, 0.0});
    std::map<int, std::size_t> indices{{form.metamers.front().axis, 0}};
    for (std::size_t i = 1; i < form.metamers.size(); ++i) {
        const GrownMetamer& metamer = form.metamers[i];
        const auto parent = static_cast<std::size_t>(metamer.parent);
        const auto [found, isNew] = indices.try_emplace(metamer.axis, axes.size());
        if (isNew) {
            WoodAxis axis;
            axis.parent = static_cast<int>(places[parent].axis);
            axis.order = metamer.order;
            axis.attach = places[parent].along;
            axis.line.add(glm::dvec3(form.metamers[parent].position));
            axis.leafy = {0.0, 0.0}; // no leaves yet
            axes.push_back(std::move(axis));
        }
        WoodAxis& axis = axes[found->second];
        const double before = axis.line.length();
        axis.line.add(glm::dvec3(metamer.position));
        const auto tip = static_cast<double>(metamer.radius);
        const double base = isNew ? tip : static_cast<double>(form.metamers[parent].radius);
        axis.radii.push_back(0.5 * (base + tip));
        axis.volume += frustumVolume(axis.line.length() - before, base, tip);
        ++axis.pieces;
        if (metamer.leafArea > 0.0f)
            axis.leafy = {axis.leafy->second > 0.0 ? axis.leafy->first : before, axis.line.length()};
        places[i] = {found->second, axis.line.length()};
    }
    return axes;
}

} // namespace

Skeleton makeSkeleton(const GrownForm& form) {
    WoodDetail detail;
    detail.maxUnits = maxUnits;
    detail.maxShoots = form.metamers.size();
    return makeSkeleton(axesOf(form), detail).skeleton;
}

} // namespace osgTreeWind
