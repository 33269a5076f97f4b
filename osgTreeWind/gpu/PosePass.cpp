// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/PosePass.h>

#include <osgTreeWind/gpu/DataTexture.h>
#include <osgTreeWind/gpu/OpenGLProfile.h>
#include <osgTreeWind/gpu/ShaderLibrary.h>

#include <osg/AlphaFunc>
#include <osg/ClipPlane>
#include <osg/FrameBufferObject>
#include <osg/GLExtensions>
#include <osg/Notify>
#include <osg/PolygonStipple>
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

/// A GPU pass within a draw: renders one rectangle into a frame buffer object, unaffected by the scene's
/// state. Its destructor restores the OpenGL state that it changed, so that osg::State remains valid.
class PassState {
public:
    explicit PassState(osg::State& state)
        : _state(state), _gl(*state.get<osg::GLExtensions>()), _program(state.getLastAppliedProgramObject()) {
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING_EXT, &_readFrameBuffer);
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING_EXT, &_drawFrameBuffer);
        glGetIntegerv(GL_CURRENT_PROGRAM, &_programHandle);
        glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &_vertexArray);
        glGetIntegerv(GL_VIEWPORT, _viewport);
        glGetIntegerv(GL_POLYGON_MODE, _polygonMode);
        glGetIntegerv(GL_ACTIVE_TEXTURE, &_activeTexture);
        for (unsigned unit = 0; unit < units; ++unit) {
            _gl.glActiveTexture(GL_TEXTURE0 + unit);
            glGetIntegerv(GL_TEXTURE_BINDING_2D, &_textures[unit]);
        }
        _gl.glActiveTexture(GL_TEXTURE0);
        for (const GLenum mode :
             {GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_FRAMEBUFFER_SRGB,
              GL_COLOR_LOGIC_OP, GL_POLYGON_OFFSET_FILL, GL_CLIP_PLANE0, GL_CLIP_PLANE0 + 1,
              GL_CLIP_PLANE0 + 2, GL_CLIP_PLANE0 + 3, GL_CLIP_PLANE0 + 4, GL_CLIP_PLANE0 + 5})
            disable(mode);
        if (!isCoreProfile(state)) {
            disable(GL_ALPHA_TEST);
            disable(GL_POLYGON_STIPPLE);
        }
        GLboolean (*isEnabled)(GLenum, GLuint) = nullptr; // osg::GLExtensions has neither
        void (*getBooleans)(GLenum, GLuint, GLboolean*) = nullptr;
        osg::setGLExtensionFuncPtr(isEnabled, "glIsEnabledi");
        osg::setGLExtensionFuncPtr(getBooleans, "glGetBooleani_v");
        for (GLuint i = 0; i < targets; ++i) {
            _blends[i] = isEnabled(GL_BLEND, i);
            getBooleans(GL_COLOR_WRITEMASK, i, _colorMasks[i]);
            _gl.glDisablei(GL_BLEND, i);
            _gl.glColorMaski(i, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        }
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        _gl.glGenVertexArrays(1, &_noArrays);
        _gl.glBindVertexArray(_noArrays);
    }
    ~PassState() {
        _gl.glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, static_cast<GLuint>(_readFrameBuffer));
        _gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT, static_cast<GLuint>(_drawFrameBuffer));
        _gl.glBindVertexArray(static_cast<GLuint>(_vertexArray));
        _gl.glDeleteVertexArrays(1, &_noArrays);
        for (unsigned unit = 0; unit < units; ++unit) {
            _gl.glActiveTexture(GL_TEXTURE0 + unit);
            glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(_textures[unit]));
        }
        _gl.glActiveTexture(static_cast<GLenum>(_activeTexture));
        glViewport(_viewport[0], _viewport[1], _viewport[2], _viewport[3]);
        if (_polygonMode[0] == _polygonMode[1] || isCoreProfile(_state)) {
            glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(_polygonMode[0]));
        } else {
            glPolygonMode(GL_FRONT, static_cast<GLenum>(_polygonMode[0]));
            glPolygonMode(GL_BACK, static_cast<GLenum>(_polygonMode[1]));
        }
        for (GLuint i = 0; i < targets; ++i) {
            if (_blends[i])
                _gl.glEnablei(GL_BLEND, i);
            _gl.glColorMaski(i, _colorMasks[i][0], _colorMasks[i][1], _colorMasks[i][2], _colorMasks[i][3]);
        }
        for (const GLenum mode : _disabled)
            glEnable(mode);
        _gl.glUseProgram(static_cast<GLuint>(_programHandle));
        _state.setLastAppliedProgramObject(_program);
    }
    PassState(const PassState&) = delete;
    PassState& operator=(const PassState&) = delete;

    /// Directs draw() to `height` rows of the target from `firstRow` on, with this program.
    void begin(osg::Program& program, osg::FrameBufferObject& target, int firstRow, int width,
               int height) const {
        target.apply(_state);
        glViewport(0, firstRow, width, height);
        program.apply(_state);
    }
    void bind(unsigned unit, const char* sampler, osg::Texture2D* texture) const {
        _gl.glActiveTexture(GL_TEXTURE0 + unit);
        texture->apply(_state);
        set(sampler, static_cast<int>(unit));
    }
    void set(const char* uniform, int value) const {
        const osg::Program::PerContextProgram* program = _state.getLastAppliedProgramObject();
        const GLint location = program ? program->getUniformLocation(osg::Uniform::getNameID(uniform)) : -1;
        if (location >= 0)
            _gl.glUniform1i(location, value);
    }
    void draw() const { glDrawArrays(GL_TRIANGLE_STRIP, 0, 4); }

private:
    static constexpr unsigned units = 4, targets = 3; ///< Those that the passes use.

    void disable(GLenum mode) {
        if (!glIsEnabled(mode))
            return;
        glDisable(mode);
        _disabled.push_back(mode);
    }

    osg::State& _state;
    const osg::GLExtensions& _gl;
    const osg::Program::PerContextProgram* _program;
    GLint _readFrameBuffer = 0, _drawFrameBuffer = 0, _programHandle = 0, _vertexArray = 0,
          _activeTexture = 0;
    GLint _viewport[4] = {}, _polygonMode[2] = {}, _textures[units] = {};
    GLboolean _blends[targets] = {}, _colorMasks[targets][4] = {};
    std::vector<GLenum> _disabled;
    GLuint _noArrays = 0;
};

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

void PosePass::apply(osg::State& state, const PosePage& page) const {
    const Context& context = preparePage(state, page);
    state.applyTextureAttribute(rotationsUnit, context.rotations);
    state.applyTextureAttribute(translationsUnit, context.translations);
    state.applyTextureAttribute(pullsUnit, context.pulls);
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

PosePass::Context& PosePass::preparePage(osg::State& state, const PosePage& page) const {
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
        return context;

    const PassState pass(state);
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
    return context;
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
