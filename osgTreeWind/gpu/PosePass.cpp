// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/PosePass.h>

#include <osgTreeWind/gpu/DataTexture.h>
#include <osgTreeWind/gpu/PassState.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/FrameBufferObject>
#include <osg/Notify>
#include <osg/observer_ptr>

#include <algorithm>
#include <array>
#include <vector>

namespace osgTreeWind {

namespace {

constexpr std::size_t maxPageTrees = 4096;

osg::ref_ptr<osg::Texture2D> floatTexture(const char* name, int width, int height) {
    osg::ref_ptr<osg::Texture2D> texture = makeFloatTexture(name);
    texture->setTextureSize(width, height);
    texture->setSourceFormat(GL_RGBA);
    texture->setSourceType(GL_FLOAT);
    return texture;
}

osg::ref_ptr<osg::FrameBufferObject> target(std::initializer_list<osg::Texture2D*> textures) {
    osg::ref_ptr<osg::FrameBufferObject> frameBuffer = new osg::FrameBufferObject;
    int buffer = osg::Camera::COLOR_BUFFER0;
    for (osg::Texture2D* texture : textures)
        frameBuffer->setAttachment(static_cast<osg::Camera::BufferComponent>(buffer++),
                                   osg::FrameBufferAttachment(texture));
    return frameBuffer;
}

/// Uploads rows of texels to the texture of the active unit.
void uploadRows(const void* texels, int width, int firstRow, int rows) {
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0); // osg::Texture sets it again before each image
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, firstRow, width, rows, GL_RGBA, GL_FLOAT, texels);
}

/// The next power of two, for few reallocations.
int capacityFor(int rows) {
    int capacity = 16;
    while (capacity < rows)
        capacity *= 2;
    return capacity;
}

} // namespace

PosePrograms::PosePrograms()
    : turns(sharedProgram("texels", "unit_turns")), poses(sharedProgram("texels", "unit_poses")) {}

/// The GL objects of a PosePass in one context. Contexts that share GL objects have separate ones, as frame
/// buffer objects cannot be shared, and the contexts may draw at the same time.
struct PosePass::Context {
    osg::observer_ptr<osg::State> state;
    unsigned id = 0;
    osg::ref_ptr<osg::Texture2D> units, matrices, requests, turns, winds, rotations, translations, pulls;
    osg::ref_ptr<osg::FrameBufferObject> turnTarget, poseTarget;
    int matrixRows = 0, treeRows = 0; ///< Allocated rows.
    std::size_t matrixTexels = 0;     ///< Uploaded texels.
    std::uint64_t generation = 0;     ///< Of the page of these poses.
    int posedTrees = 0;               ///< Trees of that page with poses.

    explicit Context(osg::State& drawn) : state(&drawn), id(drawn.getContextID()) {}

    std::array<const osg::ref_ptr<osg::Texture2D>*, 8> textures() const {
        return {&units, &matrices, &requests, &turns, &winds, &rotations, &translations, &pulls};
    }
    /// Whether texture objects were released.
    bool isLost() const {
        for (const osg::ref_ptr<osg::Texture2D>* texture : textures())
            if (*texture && !(*texture)->getTextureObject(id))
                return true;
        return false;
    }

    void allocateRows(int width, int rows) {
        treeRows = rows;
        posedTrees = 0;
        turns = floatTexture("unit turns", width, rows);
        winds = floatTexture("unit winds", width, rows);
        rotations = floatTexture("pose rotations", width, rows);
        translations = floatTexture("pose translations", width, rows);
        pulls = floatTexture("pose pulls", width, rows);
        turnTarget = target({turns, winds});
        poseTarget = target({rotations, translations, pulls});
    }

    void release(osg::State* state) const {
        for (const osg::ref_ptr<osg::Texture2D>* texture : textures())
            if (*texture)
                (*texture)->releaseGLObjects(state);
        for (const osg::ref_ptr<osg::FrameBufferObject>& frameBuffer : {turnTarget, poseTarget})
            if (frameBuffer)
                frameBuffer->releaseGLObjects(state);
    }
};

/// One of the textures of poses, which differ between contexts.
class PosePass::PoseTexture : public osg::Texture2D {
public:
    PoseTexture(const PosePass* pass, osg::ref_ptr<osg::Texture2D> Context::*texture)
        : _pass(pass), _texture(texture) {}
    void apply(osg::State& state) const override {
        osg::ref_ptr<const PosePass> pass;
        if (_pass.lock(pass))
            if (const osg::ref_ptr<osg::Texture2D>& texture = pass->findContext(state).*_texture)
                texture->apply(state);
    }

private:
    osg::observer_ptr<const PosePass> _pass; // it owns the texture
    osg::ref_ptr<osg::Texture2D> Context::*_texture;
};

PosePass::PosePass(const Skeleton& skeleton, PosePrograms* programs)
    : PoseRows(std::clamp<std::size_t>(
          static_cast<std::size_t>(DataTexture::maxRows / PoseLayout(skeleton.units.size()).rows), 1,
          maxPageTrees)),
      _programs(programs), _units(static_cast<int>(skeleton.units.size())), _layout(skeleton.units.size()) {
    _unitTexels.reserve(2 * skeleton.units.size());
    for (const BranchUnit& unit : skeleton.units) {
        _unitTexels.emplace_back(unit.base, static_cast<float>(unit.parent));
        _unitTexels.emplace_back(unit.tip, 0.0f);
    }
    const auto bind = [&](unsigned unit, osg::ref_ptr<osg::Texture2D> Context::*texture) {
        _state->setTextureAttribute(unit, new PoseTexture(this, texture),
                                    osg::StateAttribute::ON | osg::StateAttribute::PROTECTED);
    };
    bind(rotationsUnit, &Context::rotations);
    bind(translationsUnit, &Context::translations);
    bind(pullsUnit, &Context::pulls);
}

PosePass::~PosePass() = default;

void PosePass::fillRequest(const ModalMotion& motion, std::size_t tree, const TreeScale& scale,
                           const Reconfiguration& foliage, PoseRequest& request) {
    const ModalModel& model = motion.model(tree);
    findMatrix(model, request);
    request.across = scale.axes.x;
    request.upward = scale.axes.z;
    if (const TreeFall* fall = motion.fall(tree)) {
        for (std::size_t i = 0; i < fall->count; ++i) {
            const TreeFall::Part& part = fall->parts[i];
            request.fallen[i] = {part.turn.x, part.turn.y, static_cast<float>(part.unit), 0.0f};
        }
    }
    if (request.firstTexel < 0.0f)
        return;
    motion.poseVector(tree, request.vector);
    request.streamlining = foliage.streamlining;
    request.breezeStreamlining = foliage.breezeStreamlining;
    request.streamlinedTo = foliage.streamlinedTo;
    request.maxPull = foliage.maxPull;
    glm::vec3 winds[PoseRequest::maxPatches];
    motion.patchWinds(tree, winds);
    for (std::size_t patch = 0; patch < model.patches.size(); ++patch)
        std::copy_n(&winds[patch].x, 3, request.patchWinds[patch]);
}

void PosePass::findMatrix(const ModalModel& model, PoseRequest& request) {
    const std::size_t columns = model.columns(), texels = (columns + 3) / 4;
    request.rowTexels = static_cast<float>(texels);
    request.maxAngle = model.maxAngle;
    const std::lock_guard<std::mutex> lock(_matrixMutex);
    const auto [found, isNew] = _firstTexels.try_emplace(&model, static_cast<int>(_matrices.size()));
    request.firstTexel = static_cast<float>(found->second);
    if (!isNew)
        return;
    const std::size_t size = model.joints / 2 * (2 * texels + 1);
    if (_matrices.size() + size >
        std::size_t(DataTexture::width) * 8192) { // numbers of texels stay exact as floats
        OSG_WARN << "osgTreeWind: no texture space for more archetypes of one model; trees of further "
                    "archetypes do not move"
                 << std::endl;
        found->second = -1;
        request.firstTexel = -1.0f;
        return;
    }
    const float* row = model.poses.data();
    for (std::size_t joint = 0; joint < model.joints; ++joint, row += columns) {
        const std::size_t first = _matrices.size();
        _matrices.resize(first + texels, glm::vec4(0.0f));
        std::copy_n(row, columns, &_matrices[first].x);
        if (joint % 2 == 1)
            _matrices.emplace_back(static_cast<float>(model.patchOfLink[joint / 2]), 0.0f, 0.0f, 0.0f);
    }
}

void PosePass::prepareBound(osg::State& state, const PosePage& page) const {
    std::optional<PassState> passes;
    prepare(state, page, passes);
    if (!passes)
        return;
    passes.reset();
    for (const unsigned unit : {rotationsUnit, translationsUnit, pullsUnit}) {
        state.setActiveTextureUnit(unit);
        static_cast<const osg::Texture*>(_state->getTextureAttribute(unit, osg::StateAttribute::TEXTURE))
            ->apply(state);
    }
}

PosePass::Context& PosePass::findContext(osg::State& state) const {
    const std::lock_guard<std::mutex> lock(_contextMutex);
    for (const std::unique_ptr<Context>& context : _contexts)
        if (context->state == &state) {
            if (context->isLost())
                *context = Context(state);
            return *context;
        }
    _contexts.erase(std::remove_if(_contexts.begin(), _contexts.end(),
                                   [](const auto& context) { return !context->state.valid(); }),
                    _contexts.end());
    _contexts.push_back(std::make_unique<Context>(state));
    return *_contexts.back();
}

void PosePass::prepare(osg::State& state, const PosePage& page, std::optional<PassState>& passes) const {
    Context& context = findContext(state);
    const std::lock_guard<std::mutex> pageLock(page.mutex());
    const auto trees = static_cast<int>(page.requests.size());
    if (context.generation != page.generation) {
        context.generation = page.generation;
        context.posedTrees = 0;
    }
    if (trees * _layout.rows > context.treeRows)
        context.allocateRows(_layout.width, capacityFor(trees) * _layout.rows);
    const int first = context.posedTrees;
    if (first == trees)
        return;

    const PassState& pass = passes ? *passes : passes.emplace(state);
    upload(state, context, page);
    const auto begin = [&](osg::Program& program, osg::FrameBufferObject& target) {
        pass.begin(program, target, first * _layout.rows, _layout.width, (trees - first) * _layout.rows);
        pass.bind(0, "poseRequests", context.requests);
        pass.bind(1, "treeUnits", context.units);
        pass.set("unitCount", _units);
        pass.set("unitRows", _layout.rows);
    };
    begin(*_programs->turns, *context.turnTarget);
    pass.bind(2, "modalMatrices", context.matrices);
    pass.draw();
    begin(*_programs->poses, *context.poseTarget);
    pass.bind(2, "unitTurns", context.turns);
    pass.bind(3, "unitWinds", context.winds);
    pass.draw();
    context.posedTrees = trees;
}

/// Uploads the input of the passes that this context does not have yet.
void PosePass::upload(osg::State& state, Context& context, const PosePage& page) const {
    if (!context.units) {
        context.units =
            floatTexture("tree units", DataTexture::width, DataTexture::rowsFor(_unitTexels.size()));
        context.units->apply(state);
        std::vector<glm::vec4> texels = _unitTexels;
        texels.resize(static_cast<std::size_t>(context.units->getTextureHeight()) * DataTexture::width);
        uploadRows(texels.data(), DataTexture::width, 0, context.units->getTextureHeight());
    }
    const auto trees = static_cast<int>(page.requests.size());
    constexpr auto requestWidth = static_cast<int>(PoseRequest::texels);
    if (!context.requests || context.requests->getTextureHeight() < trees)
        context.requests = floatTexture("pose requests", requestWidth, capacityFor(trees));
    context.requests->apply(state);
    uploadRows(page.requests.data(), requestWidth, 0, trees);

    const std::lock_guard<std::mutex> lock(_matrixMutex);
    const int rows = DataTexture::rowsFor(_matrices.size());
    if (rows > context.matrixRows) {
        context.matrixRows = capacityFor(rows);
        context.matrices = floatTexture("modal matrices", DataTexture::width, context.matrixRows);
        context.matrixTexels = 0;
    }
    if (_matrices.size() > context.matrixTexels) {
        context.matrices->apply(state);
        const std::size_t firstRow = context.matrixTexels / DataTexture::width;
        std::vector<glm::vec4> texels(
            _matrices.begin() + static_cast<std::ptrdiff_t>(firstRow * DataTexture::width), _matrices.end());
        texels.resize((static_cast<std::size_t>(rows) - firstRow) * DataTexture::width);
        uploadRows(texels.data(), DataTexture::width, static_cast<int>(firstRow),
                   rows - static_cast<int>(firstRow));
        context.matrixTexels = _matrices.size();
    }
}

void PosePass::releaseGLObjects(osg::State* state) const {
    const std::lock_guard<std::mutex> lock(_contextMutex);
    const auto kept = std::partition(_contexts.begin(), _contexts.end(), [&](const auto& context) {
        return state && context->id != state->getContextID();
    });
    for (auto each = kept; each != _contexts.end(); ++each)
        (*each)->release(state);
    _contexts.erase(kept, _contexts.end());
}

} // namespace osgTreeWind
