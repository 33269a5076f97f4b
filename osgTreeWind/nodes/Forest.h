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
class ExceptionGuard;
class ForestSimulation;
class ForestTechnique;
class InstancedForest;
class ScenePlace;
class TilePager;
class WindSlot;
struct CanopySettings;
struct ForestDescription;
struct Species;
struct TreePlacement;
struct TreeSway;
struct TreeUnit;

/// A scene graph node that holds a forest, moves its trees in a given wind, and draws them.
///
///     osg::ref_ptr<Forest> forest = new Forest(description); // or Forest::read("forest.treewind")
///     scene->addChild(forest);
///     report(forest->setWind(std::make_shared<UniformWind>(glm::vec3(6.0f, 0.0f, 0.0f)))); // m/s, toward +x
///     if (const std::optional<TreeId> oak = forest->findTree("oak 7"))
///         if (const auto branch = forest->branch(*oak, 2))
///             branch.value()->addChild(nest); // moves with the branch
///
/// - Time: the update traversal advances the trees once per frame number, to the simulation time of the frame
///   stamp or by the fixed ForestDescription::step. They pause below a Switch that is off.
/// - Frames: metres, z up. World coordinates are those of TreePlacement. Geometry is relative to getOrigin().
///   Below transforms, the forest samples the wind at its place in the scene (docs/coordinates.md).
/// - Bounds: bounding boxes enclose the trees at rest; the bounding sphere also encloses their sway.
/// - Threads: any thread may call setWind() and getWind() at any time. Call everything else in the update
///   traversal or between frames, setDescription() only between frames. Every threading model works.
/// - Values: `TreePlacement` and `ForestDescription` are in forest/ForestDescription.h, `TreeSway` in
///   motion/damage/, `BranchTransform` in drawing/, `ForestSimulation` in motion/, `TreeUnit` beside this
///   header.
/// - Errors: a call that returns problems has changed nothing; no problems mean success. If an update runs
///   out of memory or a callback throws, OSG_WARN says so, and the trees stand still until setDescription().
class OSGTREEWIND_EXPORT Forest : public osg::Group {
public:
    Forest(); ///< A forest without trees.
    /// Calls setDescription(). If that fails, the forest is empty, and OSG_WARN gives the problems.
    explicit Forest(ForestDescription description);
    /// Reads a forest from a .treewind file; OSG_NOTICE gives the notes of the reader. @return the forest, or
    /// the problems of readForestFile() and create(). @param path of the file @param executor its threads
    static Result<osg::ref_ptr<Forest>> read(const std::string& path, Executor executor = {});
    /// Like the constructor; returns the problems. @param description its trees @param executor its threads
    static Result<osg::ref_ptr<Forest>> create(ForestDescription description, Executor executor = {});
    /// Copies the trees as they are now, at rest, with wind, season and technique; shares immutable data.
    /// Copies the host's children by `copyop`, but neither the transforms of branch() nor the callback.
    Forest(const Forest& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY);
    META_Node(osgTreeWind, Forest)

    /// Replaces all trees, and the wind if the description has one. Only between frames.
    /// @return what check() finds, or lack of memory or of texture size.
    [[nodiscard]] Diagnostics setDescription(ForestDescription description);
    /// The description as given, without its trees, but with the species of addSpecies().
    const ForestDescription& getDescription() const;

    /// Sets the wind from the next frame on. A WindField converts to a Wind; null is a calm. Any thread.
    /// @return what check() finds.
    [[nodiscard]] Diagnostics setWind(Wind wind);
    Wind getWind() const; ///< As set. Any thread.
    /// Sets how the trees change every wind, from the next frame on. @return what check() finds.
    [[nodiscard]] Diagnostics setCanopy(const CanopySettings& canopy);
    const CanopySettings& getCanopy() const; ///< At first that of the description.
    /// Runs the work of the forest on threads of the host; null: on the threads of the process.
    void setExecutor(Executor executor);
    /// Sets the season (Season.h): the leaves, and how the trees sway. @return a problem if it is not finite.
    [[nodiscard]] Diagnostics setSeason(float season);
    float getSeason() const;      ///< The season, as in Season.h.
    osg::Vec3d getOrigin() const; ///< World position of the node's own origin, metres.
    /// The surface of the ground, for the host to add to its scene; null: no ground. New in each description.
    osg::Node* getGround() const { return _ground.get(); }

    // Changes of trees need the law `modal`. Their cost does not depend on the number of trees. Trees of
    // tiles stay changed when their tile is unloaded and loaded again.

    /// Adds a species for new trees. Invalidates references from getDescription().
    /// @return its index, or what check() finds, or a problem if the name is in use.
    Result<std::size_t> addSpecies(Species species);
    /// The first tree of each shape takes some 30 ms more, except in a forest with tiles.
    /// @param placement in world coordinates. @return an id that is never used again, or what check() finds.
    Result<TreeId> addTree(const TreePlacement& placement);
    [[nodiscard]] Diagnostics removeTree(TreeId tree); ///< @return a problem if there is no such tree.
    /// Moves a tree, or gives it another size or species, while it goes on swaying. @return as addTree().
    [[nodiscard]] Diagnostics changeTree(TreeId tree, const TreePlacement& placement);
    /// The tree with a name. If its tile is not loaded, this loads it, in milliseconds.
    std::optional<TreeId> findTree(const std::string& name);
    std::size_t getNumTrees() const { return _treeCount; } ///< Includes the trees of loaded tiles.
    std::vector<TreeId> getTrees() const; ///< The ids: at first in the order of the description.
    /// The placement of a tree now, with estimates for the missing sizes; empty if there is no such tree.
    std::optional<TreePlacement> getPlacement(TreeId tree) const;
    /// The branch units of a tree now, by the index that branch() takes. Empty if there is no such tree.
    std::vector<TreeUnit> getUnits(TreeId tree) const;
    std::optional<TreeSway> sway(TreeId tree) const; ///< See ForestSimulation::sway().
    /// Sets a function that the update traversal calls for each tree or bough that the wind breaks, if the
    /// description enables `damage`. It may add, change and remove trees. Null: no callback.
    void setDamageCallback(DamageCallback callback);

    /// A transform that moves with a branch unit, without delay; the same one for each call. Its children are
    /// in the coordinates of the tree at rest, metres. After changeTree() it moves with the same unit of the
    /// changed tree. It keeps its last position if the tree or the unit is gone.
    [[nodiscard]] Result<BranchTransform*> branch(TreeId tree, unsigned unit);
    /// Removes the transform of a branch and its children. @return false if there is none.
    bool releaseBranch(TreeId tree, unsigned unit);
    bool isOwnChild(const osg::Node* child) const; ///< Whether the forest, not the host, added this child.

    /// @param technique draws this forest only; null: instances under `modal`, else branch by branch.
    [[nodiscard]] Diagnostics setTechnique(ForestTechnique* technique);
    ForestTechnique* getTechnique() const { return _technique.get(); } ///< Never null.
    InstancedForest* getInstanced() const;   ///< The technique if it draws instances; else null.
    BranchwiseForest* getBranchwise() const; ///< The technique if it draws branch by branch; else null.
    const ForestSimulation& getSimulation() const { return *_simulation; } ///< The motion, without drawing.
    void traverse(osg::NodeVisitor& visitor) override;                     ///< osg::Node.
    osg::BoundingSphere computeBound() const override;                     ///< osg::Node.

protected:
    ~Forest() override;

private:
    void rebuild(ForestDescription description);
    void setSimulation(std::shared_ptr<ForestSimulation> simulation);
    void replaceTechnique(const osg::ref_ptr<ForestTechnique>& technique);
    void update(osg::NodeVisitor& visitor);
    void unloadTree(TreeId tree);
    void report(osg::NodeVisitor& cullVisitor, double cullTime) const;
    void updatePlace(const osg::NodePath& path);

    std::shared_ptr<WindSlot> _wind; ///< Shared with `_simulation`.
    Executor _executor;
    DamageCallback _damageCallback;
    std::shared_ptr<ForestSimulation> _simulation;
    osg::ref_ptr<ForestTechnique> _technique;
    osg::ref_ptr<osg::Node> _ground;
    osg::ref_ptr<TilePager> _tiles; ///< Null for a forest without tiles.
    std::size_t _treeCount = 0;
    std::unique_ptr<ExceptionGuard> _guard;
    unsigned _lastFrame = ~0u;
    std::unique_ptr<ScenePlace> _place;
    double _frameStep = 0.0;                           ///< Seconds; 0: the frame stamp's time counts.
    double _updateDuration = 0.0;                      ///< Of the last update, seconds.
    bool _isHostTechnique = false, _hasFailed = false; ///< The host set the technique; an update failed.
};

} // namespace osgTreeWind
