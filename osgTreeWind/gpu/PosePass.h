// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/PassState.h>
#include <osgTreeWind/gpu/PosePage.h>
#include <osgTreeWind/model/Skeleton.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/Reconfiguration.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <osg/Program>
#include <osg/State>
#include <osg/StateSet>
#include <osg/Texture2D>

#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <vector>

#include <glm/vec4.hpp>

namespace osgTreeWind {

/// The two programs that all PosePasses share.
struct PosePrograms : osg::Referenced {
    PosePrograms();
    osg::ref_ptr<osg::Program> turns, poses;
};

/// Computes the poses of the visible trees of a forest on the GPU, under the law `modal`. The angle pass
/// computes the rotation of each branch unit from the tree's modal vector; the pose pass composes the
/// rotations of the units that carry each unit.
///
/// Cull traversals request poses on a PosePage. The first draw of a frame in each context computes them;
/// later draws compute those requested since. Any thread.
class PosePass : public osg::Referenced {
public:
    explicit PosePass(PosePrograms* programs);

    /// Adds the next model.
    void addModel(const Skeleton& skeleton);
    std::size_t modelCount() const { return _models.size(); }

    /// Requests the pose of a swaying tree in a frame. If the textures have no space for its archetype, the
    /// tree is posed at rest, with one warning per archetype.
    PosePlaces::Place request(unsigned frame, const ModalMotion& motion, std::uint32_t tree,
                              std::size_t model, const TreeScale& scale, const Reconfiguration& foliage);

    /// Texture units of state().
    static constexpr unsigned rotationsUnit = 12, translationsUnit = 13, pullsUnit = 14;
    /// Binds the textures of the poses that a context computed last.
    osg::StateSet* state() const { return _state.get(); }
    /// Computes the poses of a page that this context does not have yet. In a draw, with the context current.
    /// @param passes set if there are any; may serve several pages.
    void prepare(osg::State& state, const PosePage& page, std::optional<PassState>& passes) const;
    /// Likewise, after the last poses were bound: binds those of this page if they differ.
    void prepareBound(osg::State& state, const PosePage& page) const;

    void releaseGLObjects(osg::State* state) const;

protected:
    ~PosePass() override;

private:
    void fillRequest(const ModalMotion& motion, std::size_t tree, std::size_t model, const TreeScale& scale,
                     const Reconfiguration& foliage, PoseRequest& request);
    /// Writes the location and row length of an archetype's matrix [Phi R], which the first call adds.
    void findMatrix(const ModalModel& model, PoseRequest& request);

    struct GrowingTexture;
    struct Context;
    class PoseTexture;
    Context& findContext(osg::State& state) const;
    void upload(osg::State& state, Context& context, const PosePage& page, int firstRow, int rows) const;

    osg::ref_ptr<PosePrograms> _programs;
    osg::ref_ptr<osg::StateSet> _state = new osg::StateSet;
    PosePlaces _places;
    struct ModelUnits {
        std::size_t first, count; ///< Within `_units`.
    };
    std::vector<ModelUnits> _models;

    // Lock order: places, page, texels.
    mutable std::mutex _texelMutex; ///< Guards the next three members.
    std::unordered_map<const ModalModel*, int> _firstTexels;
    std::vector<glm::vec4> _units, _matrices;

    mutable std::mutex _contextMutex; ///< Guards the list. Each context is used by one thread.
    mutable std::vector<std::unique_ptr<Context>> _contexts;
};

} // namespace osgTreeWind
