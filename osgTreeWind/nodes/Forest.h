// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/TreeId.h>
#include <osgTreeWind/motion/damage/TreeDamage.h>
#include <osgTreeWind/wind/Wind.h>

#include <osg/Group>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

class BranchTransform;
class BranchwiseForest;
class EntryGuard;
class ForestSimulation;
class ForestTechnique;
class GivenWind;
class InstancedForest;
class ScenePlace;
class TilePager;
struct ForestDescription;
struct Species;
struct TreePlacement;
struct TreeUnit;

/// A forest moving in a given wind.
///
///     scene->addChild(forest = new Forest(description));
///     forest->setWind(std::make_shared<UniformWind>(glm::vec3(6.0f, 0.0f, 0.0f)));
///
/// The update traversal moves it on, once per frame number, to the frame stamp's time or by a fixed step
/// (ForestDescription::step). It rests below a Switch that is off, and meets the wind of where it really is
/// (docs/coordinates.md). Its boxes are of trees at rest, its sphere holds them as they sway.
class OSGTREEWIND_EXPORT Forest : public osg::Group {
public:
    Forest();
    /// As setDescription(). What that refuses leaves the forest empty, and a warning says why.
    explicit Forest(ForestDescription description);
    /// The same with the problems as an answer.
    /// @param description as of setDescription(). @param executor as of setExecutor().
    static Result<osg::ref_ptr<Forest>> create(ForestDescription description, Executor executor = {});
    /// The same trees as they are now, at rest, in the wind `other` has; shares what does not change. Other
    /// children go by `copyop`; branches that are followed are not copied.
    Forest(const Forest& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, Forest)
        /// Replaces all trees, and the wind by that of the description if it has one. Not during a traversal.
        /// @return the problems, and nothing is changed: what check() finds, no memory, no room in textures.
        [[nodiscard]] Diagnostics setDescription(ForestDescription description);
    /// As given, but without its trees, with the species that were added, and with its first wind and season.
    const ForestDescription& getDescription() const;

    /// The wind from the next frame on; a field by itself is one, null is a calm. One without a canopy keeps
    /// that of the wind before. Any thread, any time. @return what check() finds; then the wind stays.
    Diagnostics setWind(Wind wind);
    Wind getWind() const; ///< As set, with its canopy.

    /// A host's threads (SimulationOptions::executor); null: the process's own. In update or between frames.
    void setExecutor(Executor executor);

    /// Of the year (species/Season.h): leaves, and how trees sway with them. In update or between frames.
    /// @return a problem for what is not finite.
    Diagnostics setSeason(float season);
    float getSeason() const; ///< Of the year.

    osg::Vec3d getOrigin() const; ///< Its own zero in the world's frame: geometry is relative to it.
    /// The ground, for a host to draw beside the trees; null: none. Another one after setDescription().
    osg::Node* getGround() const { return _ground.get(); }

    // In update or between frames, at the same cost in any forest, under the law `modal` alone. What is
    // done to trees of tiles lasts. A call that returns problems changes nothing.

    /// Makes the shapes of a species, for trees to come. The reference that getDescription() gave before is
    /// no longer valid. @return its index, or what check() finds, a name that is taken, no memory.
    Result<std::size_t> addSpecies(Species species);
    /// @param placement in the world's frame. @return an id that lasts, or what check() finds.
    Result<TreeId> addTree(const TreePlacement& placement);
    Diagnostics removeTree(TreeId tree); ///< @return the problems; empty when it is done.
    /// Moves it, or makes it one of another size or species, in full sway. @return the problems.
    Diagnostics changeTree(TreeId tree, const TreePlacement& placement);
    /// By the name it has; noTree for none. One whose tile is not there is read from it, in milliseconds.
    TreeId findTree(const std::string& name);
    std::size_t getNumTrees() const { return _treeCount; } ///< Those of tiles that are there, too.
    /// Their ids, those of the description first and in its order as long as none was removed.
    std::vector<TreeId> getTrees() const;
    /// What would put it up again, with all of its sizes; nothing for a tree that is not there.
    std::optional<TreePlacement> getPlacement(TreeId tree) const;
    /// Its branch units by the numbers that branch() takes, and where they are now; none for no tree.
    /// nearestUnit() finds one by its place. In update or between frames.
    std::vector<TreeUnit> getUnits(TreeId tree) const;

    /// Called in update for each tree or bough that the wind brings down, with `damage` in the description.
    /// It may add, change and remove trees. Null: nobody is told. Not copied.
    void setDamageCallback(DamageCallback callback);

    /// A transform that goes where a branch goes, in the same video frame, and always the same one; below it
    /// is the frame of its tree at rest, in metres. changeTree() moves it to the branch of that number of the
    /// other tree; it stays where it was when that is gone. In update or between frames.
    [[nodiscard]] Result<BranchTransform*> branch(TreeId tree, unsigned unit);
    bool unfollow(TreeId tree, unsigned unit); ///< With what hangs on it. @return whether it was followed.
    bool isOwnChild(const osg::Node* child) const; ///< A part of the forest; all others are yours.

    /// Draws its trees, and no other's; null: instances under `modal`, else branch by branch. As setSeason().
    Diagnostics setTechnique(ForestTechnique* technique);
    ForestTechnique* getTechnique() const { return _technique.get(); } ///< Never null.
    InstancedForest* getInstanced() const;   ///< The technique, if it draws instances; else null.
    BranchwiseForest* getBranchwise() const; ///< The technique, if it draws branch by branch; else null.

    /// Wind, angles and poses behind the picture. Read it between frames.
    const ForestSimulation& getSimulation() const { return *_simulation; }

    void traverse(osg::NodeVisitor& visitor) override; ///< osg::Node.
    osg::BoundingSphere computeBound() const override; ///< osg::Node.

protected:
    ~Forest() override;

private:
    void grow(ForestDescription description);
    void show(std::shared_ptr<ForestSimulation> simulation);
    void showTechnique(const osg::ref_ptr<ForestTechnique>& technique);
    void update(osg::NodeVisitor& visitor);
    void unload(TreeId tree);
    void report(osg::NodeVisitor& cullVisitor, double cullTime) const;
    void tellPlace(const osg::NodePath& path);

    std::shared_ptr<GivenWind> _wind; ///< Of `_simulation` too.
    Executor _executor;
    DamageCallback _damageCallback;
    std::shared_ptr<ForestSimulation> _simulation;
    osg::ref_ptr<ForestTechnique> _technique;
    osg::ref_ptr<osg::Node> _ground;
    osg::ref_ptr<TilePager> _tiles; ///< Null: all trees are there.
    std::size_t _treeCount = 0;
    std::unique_ptr<EntryGuard> _guard; ///< Of its traversals.
    unsigned _lastFrame = ~0u;
    std::unique_ptr<ScenePlace> _place;
    double _frameStep = 0.0;                 ///< How long a frame lasts, seconds; 0: as its stamp says.
    double _stepTime = 0.0;                  ///< Of the last update, seconds.
    bool _isHosts = false, _stopped = false; ///< A host has set the technique; an update has failed.
};

} // namespace osgTreeWind
