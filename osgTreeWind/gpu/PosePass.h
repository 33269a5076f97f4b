// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/PoseRows.h>
#include <osgTreeWind/model/Skeleton.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/Reconfiguration.h>
#include <osgTreeWind/motion/modal/ModalReader.h>

#include <osg/Program>
#include <osg/State>
#include <osg/Texture2D>

#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include <glm/vec4.hpp>

namespace osgTreeWind {

/// The two programs that all PosePasses share.
struct PosePrograms : osg::Referenced {
    PosePrograms();
    osg::ref_ptr<osg::Program> turns, poses;
};

/// Poses of the trees of one model that are drawn, worked out on the GPU under the law `modal`: the angle
/// pass makes unit angles of each tree's short vector, the pose pass walks the units that carry each unit.
///
/// Culls ask for rows; the first draw of a frame in each context works them out, and later ones what was
/// asked for since. Any thread.
class PosePass : public osg::Referenced, public PoseRows {
public:
    PosePass(const Skeleton& skeleton, PosePrograms* programs);

    /// Fills in what is asked of a tree that sways. One whose archetype is past what a texture holds is posed
    /// at rest, with one warning.
    void ask(const ModalReader& motion, std::size_t tree, const TreeScale& scale,
             const Reconfiguration& foliage, PoseRequest& request);

    /// Texture units that apply() binds.
    static constexpr unsigned rotationsUnit = 4, translationsUnit = 5, pullsUnit = 6;
    /// Works out the poses of a page that this context does not have yet. In a draw, with the context
    /// current.
    void prepare(osg::State& state, const PosePage& page) const { prepared(state, page); }
    /// The same, and binds them.
    void apply(osg::State& state, const PosePage& page) const;

    void releaseGLObjects(osg::State* state) const;

protected:
    ~PosePass() override;

private:
    /// Where [Phi R] of an archetype stands, and how long its rows are; added on the first call.
    void refer(const ModalModel& model, PoseRequest& request);

    struct Context;
    Context& contextOf(osg::State& state) const;
    Context& prepared(osg::State& state, const PosePage& page) const;
    void upload(osg::State& state, Context& context, const PosePage& page) const;

    osg::ref_ptr<PosePrograms> _programs;
    int _units;
    PoseLayout _layout;
    std::vector<glm::vec4> _unitTexels;

    // Locked after that of the rows and that of a page.
    mutable std::mutex _matrixMutex; ///< Guards the next two.
    std::unordered_map<const ModalModel*, int> _firstTexels;
    std::vector<glm::vec4> _matrices;

    mutable std::mutex _contextMutex; ///< Guards the list; each context is used by one thread.
    mutable std::vector<std::unique_ptr<Context>> _contexts;
};

} // namespace osgTreeWind
