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
int capacityFor(std::size_t rows) {
    int capacity = 1;
    while (static_cast<std::size_t>(capacity) < rows)
        capacity *= 2;
    return capacity;
}

} // namespace

PosePrograms::PosePrograms()
    : turns(sharedProgram("texels", "unit_turns")), poses(sharedProgram("texels", "unit_poses")) {}

/// A texture with a copy of an array that grows.
struct PosePass::GrowingTexture {
    const char* name;
    osg::ref_ptr<osg::Texture2D> texture{};
    std::size_t uploaded = 0; ///< Texels.

    void upload(osg::State& state, const std::vector<glm::vec4>& texels) {
        constexpr auto width = static_cast<std::size_t>(DataTexture::width);
        const int rows = DataTexture::rowsFor(texels.size());
        if (!texture || texture->getTextureHeight() < rows) {
            texture = floatTexture(name, DataTexture::width, capacityFor(static_cast<std::size_t>(rows)));
            uploaded = 0;
        }
        if (uploaded == texels.size())
            return;
        texture->apply(state);
        const std::size_t firstRow = uploaded / width;
        std::vector<glm::vec4> added(texels.begin() + static_cast<std::ptrdiff_t>(firstRow * width),
                                     texels.end());
        added.resize((static_cast<std::size_t>(rows) - firstRow) * width);
        uploadRows(added.data(), DataTexture::width, static_cast<int>(firstRow),
                   rows - static_cast<int>(firstRow));
        uploaded = texels.size();
    }
};

/// The GL objects of a PosePass in one context. Contexts that share GL objects have separate ones, as frame
/// buffer objects cannot be shared, and the contexts may draw at the same time.
struct PosePass::Context {
    osg::observer_ptr<osg::State> state;
    unsigned id = 0;
    GrowingTexture units{"tree units"}, matrices{"modal matrices"};
    osg::ref_ptr<osg::Texture2D> requests, blocks, turns, winds, rotations, translations, pulls;
    osg::ref_ptr<osg::FrameBufferObject> turnTarget, poseTarget;
    std::uint64_t generation = 0;                ///< Of the page of these poses.
    std::size_t posedTrees = 0, posedBlocks = 0; ///< Of that page.

    explicit Context(osg::State& drawn) : state(&drawn), id(drawn.getContextID()) {}

    std::array<const osg::ref_ptr<osg::Texture2D>*, 9> textures() const {
        return {&units.texture, &matrices.texture, &requests,     &blocks, &turns,
                &winds,         &rotations,        &translations, &pulls};
    }
    /// Whether texture objects were released.
    bool isLost() const {
        for (const osg::ref_ptr<osg::Texture2D>* texture : textures())
            if (*texture && !(*texture)->getTextureObject(id))
                return true;
        return false;
    }

    void allocateRows(int rows) {
        constexpr int width = DataTexture::width;
        posedTrees = posedBlocks = 0;
        blocks = floatTexture("pose blocks", PosePage::rowBlocks, rows);
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

PosePass::PosePass(PosePrograms* programs) : _programs(programs) {
    const auto bind = [&](unsigned unit, osg::ref_ptr<osg::Texture2D> Context::*texture) {
        _state->setTextureAttribute(unit, new PoseTexture(this, texture),
                                    osg::StateAttribute::ON | osg::StateAttribute::PROTECTED);
    };
    bind(rotationsUnit, &Context::rotations);
    bind(translationsUnit, &Context::translations);
    bind(pullsUnit, &Context::pulls);
}

PosePass::~PosePass() = default;

void PosePass::addModel(const Skeleton& skeleton) {
    const std::lock_guard<std::mutex> lock(_texelMutex);
    _models.push_back({_units.size() / 2, skeleton.units.size()});
    for (const BranchUnit& unit : skeleton.units) {
        _units.emplace_back(unit.base, static_cast<float>(unit.parent));
        _units.emplace_back(unit.tip, 0.0f);
    }
}

PosePlaces::Place PosePass::request(unsigned frame, const ModalMotion& motion, std::uint32_t tree,
                                    std::size_t model, const TreeScale& scale,
                                    const Reconfiguration& foliage) {
    return _places.place(frame, tree, _models[model].count, [&](PoseRequest& request) {
        fillRequest(motion, tree, model, scale, foliage, request);
    });
}

void PosePass::fillRequest(const ModalMotion& motion, std::size_t tree, std::size_t treeModel,
                           const TreeScale& scale, const Reconfiguration& foliage, PoseRequest& request) {
    const ModalModel& model = motion.model(tree);
    findMatrix(model, request);
    request.firstUnit = static_cast<float>(_models[treeModel].first);
    request.units = static_cast<float>(_models[treeModel].count);
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
    const ModalMotion::PoseVector vector = motion.poseVector(tree);
    std::copy_n(vector.begin(), model.columns(), request.vector);
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
    const std::lock_guard<std::mutex> lock(_texelMutex);
    const auto [found, isNew] = _firstTexels.try_emplace(&model, static_cast<int>(_matrices.size()));
    request.firstTexel = static_cast<float>(found->second);
    if (!isNew)
        return;
    const std::size_t size = model.joints / 2 * (2 * texels + 1);
    if (_matrices.size() + size > DataTexture::maxTexels) {
        OSG_WARN << "osgTreeWind: no texture space for more archetypes; trees of further archetypes do not "
                    "move"
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
    if (_matrices.size() % 2 == 1) // even numbers below 2^25 are exact as floats
        _matrices.emplace_back();
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
    if (context.generation != page.generation) {
        context.generation = page.generation;
        context.posedTrees = context.posedBlocks = 0;
    }
    const std::size_t blocks = page.blocks.size();
    const auto rows = static_cast<int>((blocks + PosePage::rowBlocks - 1) / PosePage::rowBlocks);
    if (!context.turns || rows > context.turns->getTextureHeight()) {
        context.allocateRows(capacityFor(static_cast<std::size_t>(rows)));
        for (const unsigned unit : {rotationsUnit, translationsUnit, pullsUnit})
            state.haveAppliedTextureAttribute(unit, osg::StateAttribute::TEXTURE); // those of before
    }
    if (context.posedBlocks == blocks)
        return;

    const PassState& pass = passes ? *passes : passes.emplace(state);
    const auto firstRow = static_cast<int>(context.posedBlocks / PosePage::rowBlocks);
    upload(state, context, page, firstRow, rows);
    const auto begin = [&](osg::Program& program, osg::FrameBufferObject& target) {
        pass.begin(program, target, firstRow, DataTexture::width, rows - firstRow);
        pass.bind(0, "poseRequests", context.requests);
        pass.bind(1, "poseBlocks", context.blocks);
        pass.bind(2, "treeUnits", context.units.texture);
    };
    begin(*_programs->turns, *context.turnTarget);
    pass.bind(3, "modalMatrices", context.matrices.texture);
    pass.draw();
    begin(*_programs->poses, *context.poseTarget);
    pass.bind(3, "unitTurns", context.turns);
    pass.bind(4, "unitWinds", context.winds);
    pass.draw();
    context.posedTrees = page.requests.size();
    context.posedBlocks = blocks;
}

/// Uploads the input of the passes that this context does not have yet. @param firstRow of blocks.
void PosePass::upload(osg::State& state, Context& context, const PosePage& page, int firstRow,
                      int rows) const {
    const auto trees = static_cast<int>(page.requests.size());
    constexpr auto requestWidth = static_cast<int>(PoseRequest::texels);
    if (!context.requests || context.requests->getTextureHeight() < trees) {
        context.requests = floatTexture("pose requests", requestWidth, capacityFor(page.requests.size()));
        context.posedTrees = 0;
    }
    context.requests->apply(state);
    const auto firstTree = static_cast<int>(context.posedTrees);
    uploadRows(&page.requests[context.posedTrees], requestWidth, firstTree, trees - firstTree);

    constexpr std::size_t rowBlocks = PosePage::rowBlocks;
    constexpr PosePage::Block unused{0.0f, 1e6f};
    std::vector<PosePage::Block> blocks(
        page.blocks.begin() + static_cast<std::ptrdiff_t>(firstRow * rowBlocks), page.blocks.end());
    blocks.resize(static_cast<std::size_t>(rows - firstRow) * rowBlocks, unused);
    context.blocks->apply(state);
    uploadRows(blocks.data(), rowBlocks, firstRow, rows - firstRow);

    const std::lock_guard<std::mutex> lock(_texelMutex);
    context.units.upload(state, _units);
    context.matrices.upload(state, _matrices);
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
