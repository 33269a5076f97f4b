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

/// Computes the poses of the visible trees of one model on the GPU, under the law `modal`. The angle pass
/// computes the rotation of each branch unit from the tree's modal vector; the pose pass composes the
/// rotations of the units that carry each unit.
///
/// Cull traversals request rows of a PosePage, one per tree. The first draw of a frame in each context
/// computes them; later draws compute the rows requested since. Any thread.
class PosePass : public osg::Referenced, public PoseRows {
public:
    PosePass(const Skeleton& skeleton, PosePrograms* programs);

    /// Writes the request of a swaying tree. If the textures have no space for its archetype, the tree is
    /// posed at rest, with one warning per archetype.
    void fillRequest(const ModalMotion& motion, std::size_t tree, const TreeScale& scale,
                     const Reconfiguration& foliage, PoseRequest& request);

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
    /// Writes the location and row length of an archetype's matrix [Phi R], which the first call adds.
    void findMatrix(const ModalModel& model, PoseRequest& request);

    struct Context;
    class PoseTexture;
    Context& findContext(osg::State& state) const;
    void upload(osg::State& state, Context& context, const PosePage& page) const;

    osg::ref_ptr<PosePrograms> _programs;
    osg::ref_ptr<osg::StateSet> _state = new osg::StateSet;
    int _units;
    PoseLayout _layout;
    std::vector<glm::vec4> _unitTexels;

    // Lock order: rows, page, matrices.
    mutable std::mutex _matrixMutex; ///< Guards the next two members.
    std::unordered_map<const ModalModel*, int> _firstTexels;
    std::vector<glm::vec4> _matrices;

    mutable std::mutex _contextMutex; ///< Guards the list. Each context is used by one thread.
    mutable std::vector<std::unique_ptr<Context>> _contexts;
};

} // namespace osgTreeWind
