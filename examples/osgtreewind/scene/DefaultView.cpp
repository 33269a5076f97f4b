// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/DefaultView.h>

#include <examples/osgtreewind/scene/Daylight.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <osg/Math>

#include <algorithm>
#include <array>
#include <vector>

namespace math = osgTreeWind::math;

namespace {

using osgTreeWind::Forest;

constexpr double eyeHeight = 1.6;

struct Tree {
    osg::Vec3d foot;
    double height, reach; ///< Height, and radius of the crown.
    bool isOnLevel;       ///< The ground is level, so every place is as high as the foot.

    double topAbove(const osg::Vec3d& place) const {
        return isOnLevel ? height : foot.z() + height - place.z();
    }
};

/// The trees nearest to the middle tree, nearest first.
std::vector<Tree> middleTrees(const Forest& forest) {
    constexpr std::size_t most = 1500;
    const osg::Vec3d centre = forest.getBound().center();
    std::vector<Tree> trees;
    for (const osgTreeWind::PlacedTree& tree : movingForest(forest.getSimulation()).trees())
        if (tree.alive) {
            const osgTreeWind::TreeSize size = movingForest(forest.getSimulation()).placed().sizeOf(tree);
            trees.push_back({osg::Vec3d(tree.position.x, tree.position.y, tree.position.z), size.height,
                             0.5 * size.crownWidth, !forest.getGround()});
        }
    const auto sortFrom = [&trees](const osg::Vec3d& place) {
        std::stable_sort(trees.begin(), trees.end(), [&](const Tree& a, const Tree& b) {
            return (a.foot - place).length2() < (b.foot - place).length2();
        });
    };
    sortFrom(osg::Vec3d(centre.x(), centre.y(), 0.0));
    if (!trees.empty())
        sortFrom(trees.front().foot);
    if (trees.size() > most)
        trees.resize(most);
    return trees;
}

/// Rates level views in one direction.
class ViewRating {
public:
    ViewRating(const Lens& lens)
        : _tall(math::tan(osg::DegreesToRadians(0.5 * lens.fieldOfView))), _wide(_tall * lens.aspect),
          _highest(math::tan(math::atan(0.72 * _tall) + math::atan(0.55 * _tall))) {}

    /// How well trees fill the picture; 0 if a tree is in the way or its top is cut off.
    /// @param eye z is the height of the ground.
    double rate(const std::vector<Tree>& trees, const osg::Vec3d& eye, const osg::Vec2d& ahead) const {
        std::array<double, columns> skyline{};
        const osg::Vec2d right(ahead.y(), -ahead.x());
        double cutOff = 0.0;
        for (const Tree& tree : trees) {
            const osg::Vec2d way(tree.foot.x() - eye.x(), tree.foot.y() - eye.y());
            if (way.length() < tree.reach + 1.5)
                return 0.0;
            const double depth = way * ahead, aside = way * right;
            if (depth < 0.5)
                continue;
            const double low = (aside - tree.reach) / (depth * _wide),
                         high = (aside + tree.reach) / (depth * _wide);
            if (high < -1.0 || low > 1.0)
                continue;
            const double top =
                (tree.topAbove(eye) - eyeHeight) / (std::max(depth - 0.5 * tree.reach, 0.5) * _highest);
            if (top > 1.0)
                return 0.0;
            if (low < -1.0 || high > 1.0) // at the edge of the picture
                cutOff += top * top;
            for (int i = columnOf(low); i <= columnOf(high); ++i)
                skyline[static_cast<std::size_t>(i)] = std::max(skyline[static_cast<std::size_t>(i)], top);
        }
        double filled = 0.0;
        for (const double top : skyline)
            filled += top / columns;
        return filled / (1.0 + 0.5 * cutOff);
    }

    /// Elevation to look at, as a tangent, so that the picture holds ground, trees up to `top` (a tangent)
    /// and sky.
    double pitch(double top) const {
        const double middle = 0.5 * math::atan(top);
        return std::clamp(math::tan(middle), 0.2 * _tall, 0.55 * _tall);
    }
    /// Smallest distance from which a tree is not cut off.
    double distanceOf(const Tree& tree) const {
        return std::max(tree.height - eyeHeight, 0.5) / _highest + 0.5 * tree.reach;
    }
    /// Turns a direction. @param part of the horizontal angle of view, positive to the left.
    osg::Vec2d turned(const osg::Vec2d& way, double part) const {
        const double angle = 2.0 * part * math::atan(_wide);
        return {way.x() * math::cos(angle) - way.y() * math::sin(angle),
                way.x() * math::sin(angle) + way.y() * math::cos(angle)};
    }

private:
    static constexpr int columns = 48;
    static int columnOf(double across) {
        return std::clamp(static_cast<int>(0.5 * (across + 1.0) * columns), 0, columns - 1);
    }
    double _tall, _wide; ///< Tangents of half the angles of view.
    double _highest;     ///< Tangent of the highest elevation of a tree top.
};

osg::Vec2d toward(double azimuth) {
    return {math::cos(azimuth), math::sin(azimuth)};
}

} // namespace

double groundHeight(const Forest& forest, const osg::Vec2d& place, double level) {
    const osg::Vec3d origin = forest.getOrigin();
    const osgTreeWind::GroundPtr& ground = forest.getDescription().ground;
    const auto height =
        ground ? ground->height({place.x() + origin.x(), place.y() + origin.y()}) : std::nullopt;
    return height ? *height - origin.z() : level;
}

osg::Vec3d defaultEye(const osg::Vec3d& centre, double radius, const Lens& lens) {
    const double halfAngle = osg::DegreesToRadians(0.5 * lens.fieldOfView) * std::min(1.0, lens.aspect);
    const double rise = radius < 15.0 ? 0.05 : radius < 100.0 ? 0.16 : 0.28;
    osg::Vec3d direction(-0.5, -1.0, rise);
    direction.normalize();
    return centre + direction * (0.62 * radius / math::sin(halfAngle));
}

ForestView viewAtEyeLevel(const Forest& forest, const Lens& lens, const osg::Vec3& toSun) {
    constexpr std::size_t subjects = 250;
    constexpr int directions = 16;
    const std::vector<Tree> trees = middleTrees(forest);
    if (trees.empty())
        return {osg::Vec3d(0.0, -10.0, eyeHeight), osg::Vec3d(0.0, 0.0, eyeHeight)};
    const ViewRating rating(lens);
    osg::Vec2d sunward(toSun.x(), toSun.y());
    sunward.normalize();
    double best = -1.0;
    osg::Vec2d eye, ahead;
    for (std::size_t i = 0; i < std::min(trees.size(), subjects); ++i) {
        const Tree& subject = trees[i];
        for (int direction = 0; direction < directions; ++direction) {
            const osg::Vec2d way = toward(2.0 * osg::PI * direction / directions);
            const osg::Vec2d place =
                osg::Vec2d(subject.foot.x(), subject.foot.y()) - way * (rating.distanceOf(subject) + 0.5);
            const osg::Vec3d stand(place, groundHeight(forest, place, subject.foot.z()));
            for (const double aside : {0.0, -0.35, 0.35}) { // share of the angle of view
                const osg::Vec2d look = rating.turned(way, aside);
                const double sunny = 1.0 - 0.2 * (way * sunward); // best with the sun behind the eye
                const double seen = sunny * rating.rate(trees, stand, look);
                if (seen > best + 1e-6) {
                    best = seen;
                    eye = place;
                    ahead = look;
                }
            }
        }
    }
    const auto nearest = std::min_element(trees.begin(), trees.end(), [&](const Tree& a, const Tree& b) {
        const auto distance = [&](const Tree& tree) {
            return (osg::Vec2d(tree.foot.x(), tree.foot.y()) - eye).length2();
        };
        return distance(a) < distance(b);
    });
    const osg::Vec3d stand(eye, groundHeight(forest, eye, nearest->foot.z()));
    double top = 0.0;
    for (const Tree& tree : trees) {
        const osg::Vec2d way(tree.foot.x() - eye.x(), tree.foot.y() - eye.y());
        if (way * ahead > 0.8 * way.length())
            top = std::max(top, (tree.topAbove(stand) - eyeHeight) / (way * ahead));
    }
    const osg::Vec3d from = stand + osg::Vec3d(0.0, 0.0, eyeHeight);
    return {from, from + osg::Vec3d(ahead.x(), ahead.y(), rating.pitch(top)) * 10.0};
}

ForestView viewOfOneTree(const Forest& forest, const Lens& lens) {
    const std::vector<Tree> trees = middleTrees(forest);
    if (trees.empty())
        return viewAtEyeLevel(forest, lens, Daylight::usualSun);
    const Tree& tree = trees.front();
    const double half = math::tan(osg::DegreesToRadians(0.5 * lens.fieldOfView)) * std::min(1.0, lens.aspect);
    const double distance =
        0.57 * std::max(tree.height, 2.0 * tree.reach / std::max(1.0, lens.aspect)) / half + tree.reach;
    double clearest = -1e9;
    osg::Vec2d away;
    for (int turn = 0; turn < 16; ++turn) {
        const osg::Vec2d way = toward(osg::DegreesToRadians(-115.0 + 22.5 * turn)); // starting from the south
        double room = 4.0;
        for (std::size_t i = 1; i < trees.size(); ++i) {
            const osg::Vec2d other(trees[i].foot.x() - tree.foot.x(), trees[i].foot.y() - tree.foot.y());
            const double along = std::clamp(other * way, 0.0, distance + trees[i].reach);
            if (along > 0.0)
                room = std::min(room, (other - way * along).length() - trees[i].reach);
        }
        if (room > clearest + 0.1) {
            clearest = room;
            away = way;
        }
    }
    osg::Vec3d eye = tree.foot + osg::Vec3d(away.x() * distance, away.y() * distance, eyeHeight);
    eye.z() = std::max(eye.z(), groundHeight(forest, {eye.x(), eye.y()}, tree.foot.z()) + eyeHeight);
    return {eye, tree.foot + osg::Vec3d(0.0, 0.0, 0.5 * tree.height)};
}
