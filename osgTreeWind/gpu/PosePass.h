// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/PosePage.h>
#include <osgTreeWind/model/Skeleton.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/Reconfiguration.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <osg/Program>
#include <osg/State>
#include <osg/Texture2D>

#include <cstdint>
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
class PosePass : public osg::Referenced {
public:
    PosePass(const Skeleton& skeleton, PosePrograms* programs);

    /// Fills in what is asked of a tree that sways. One whose archetype is past what a texture holds is posed
    /// at rest, with one warning.
    void ask(const ModalMotion& motion, std::size_t tree, const TreeScale& scale,
             const Reconfiguration& foliage, PoseRequest& request);

    /// A tree's row among those of the frame.
    struct Row {
        PosePage* page;
        int row;
    };
    /// The same for all who ask in one frame; `fill`, given a PoseRequest&, is called for the first.
    /// @param tree any number that stands for it.
    template <typename Fill>
    Row row(unsigned frame, std::uint32_t tree, const Fill& fill) {
        const std::lock_guard<std::mutex> lock(_rowMutex);
        bool isNew = false;
        const Row row = rowOf(frame, tree, isNew);
        if (isNew) {
            const std::lock_guard<std::mutex> pageLock(row.page->mutex());
            fill(row.page->requests.emplace_back());
        }
        return row;
    }

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
    struct Entry {
        std::uint32_t tree = 0, frame = ~0u, place = 0;
    };

    Row rowOf(unsigned frame, std::uint32_t tree, bool& isNew);
    Entry& entry(std::uint32_t tree);
    PosePage* freshPage();
    Context& contextOf(osg::State& state) const;
    Context& prepared(osg::State& state, const PosePage& page) const;
    void upload(osg::State& state, Context& context, const PosePage& page) const;

    osg::ref_ptr<PosePrograms> _programs;
    int _units;
    PoseLayout _layout;
    std::size_t _pageTrees; ///< The most on a page.
    std::vector<glm::vec4> _unitTexels;

    // Locked in this order: rows, a page, matrices.
    mutable std::mutex _matrixMutex; ///< Guards the next two.
    std::unordered_map<const ModalModel*, int> _firstTexels;
    std::vector<glm::vec4> _matrices;

    std::mutex _rowMutex; ///< Guards all up to contexts.
    unsigned _frame = ~0u;
    std::uint64_t _fillings = 0; ///< Of pages.
    std::uint32_t _asked = 0;
    std::vector<Entry> _entries; ///< A hash table, a power of two long.
    std::vector<osg::ref_ptr<PosePage>> _pages, _spare;

    mutable std::mutex _contextMutex; ///< Guards the list; each context is used by one thread.
    mutable std::vector<std::unique_ptr<Context>> _contexts;
};

} // namespace osgTreeWind
