// SPDX-License-Identifier: MIT
// Functions of OpenGL 1.1 that this file defines precede those of the driver, because a program's symbols do
// so. For later functions, OSG asks osg::getGLExtensionFuncPtr(), which this file also replaces.
#define GL_GLEXT_PROTOTYPES
#include <examples/osgtreewind/bench/GlCounts.h>

#include <examples/osgtreewind/bench/TextureFetches.h>

#include <osg/GLExtensions>
#include <osg/Image>

#include <GL/gl.h>
#include <GL/glext.h>
#include <dlfcn.h>

#include <atomic>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace {

enum class Function {
#define CORE(kind, name, ...) name,
#define LATER(kind, name) name,
#include <examples/osgtreewind/bench/GlFunctions.def>
};
constexpr GlCall kinds[] = {
#define CORE(kind, ...) GlCall::kind,
#define LATER(kind, name) GlCall::kind,
#include <examples/osgtreewind/bench/GlFunctions.def>
};

/// What a program draws, and texture fetches of its shaders.
struct ProgramCost {
    DrawnPart part = DrawnPart::Other;
    std::uint64_t fetchesPerVertex = 0, fetchesPerFragment = 0;
};

struct Counting {
    GlCounts counts;
    bool withWork = false;
    std::map<GLuint, ProgramCost> programs;
    std::array<GLuint, 6> queries{}; ///< Made by the first draw; the context deletes them.
};
Counting* counting = nullptr;

/// The function that this file's one replaces.
template <class Type>
Type* nextFunction(const char* name) {
    return reinterpret_cast<Type*>(dlsym(RTLD_NEXT, name));
}
void* nextExtension(const char* name) {
    static auto* const next = nextFunction<void*(const char*)>("_ZN3osg21getGLExtensionFuncPtrEPKc");
    return next(name);
}
/// A function of OpenGL that is not counted.
#define UNCOUNTED(name) reinterpret_cast<decltype(&::name)>(nextExtension(#name))

ProgramCost costOf(GLuint program) {
    ProgramCost cost;
    constexpr std::pair<const char*, DrawnPart> samplers[] = {{"leafTexture", DrawnPart::Leaves},
                                                              {"barkTexture", DrawnPart::Bark},
                                                              {"impostorColors", DrawnPart::Pictures},
                                                              {"poseRequests", DrawnPart::Poses}};
    for (const auto& [sampler, part] : samplers)
        if (UNCOUNTED(glGetUniformLocation)(program, sampler) >= 0)
            cost.part = part;
    GLuint shaders[8];
    GLsizei count = 0;
    UNCOUNTED(glGetAttachedShaders)(program, 8, &count, shaders);
    for (GLsizei i = 0; i < count; ++i) {
        GLint type = 0, length = 0;
        UNCOUNTED(glGetShaderiv)(shaders[i], GL_SHADER_TYPE, &type);
        UNCOUNTED(glGetShaderiv)(shaders[i], GL_SHADER_SOURCE_LENGTH, &length);
        std::string text(static_cast<std::size_t>(length), '\0');
        UNCOUNTED(glGetShaderSource)(shaders[i], length, nullptr, text.data());
        (type == GL_VERTEX_SHADER ? cost.fetchesPerVertex : cost.fetchesPerFragment) +=
            static_cast<std::uint64_t>(textureFetches(text));
    }
    return cost;
}

/// Queries around a draw.
class MeasuredDraw {
public:
    explicit MeasuredDraw(Counting& counting) : _counting(counting.withWork ? &counting : nullptr) {
        if (_counting && !_counting->queries.front())
            UNCOUNTED(glGenQueries)(static_cast<GLsizei>(targets.size()), _counting->queries.data());
        for (std::size_t i = 0; _counting && i < targets.size(); ++i)
            UNCOUNTED(glBeginQuery)(targets[i], _counting->queries[i]);
    }
    MeasuredDraw(const MeasuredDraw&) = delete;
    MeasuredDraw& operator=(const MeasuredDraw&) = delete;
    ~MeasuredDraw() {
        if (!_counting)
            return;
        DrawWork work;
        work.draws = 1;
        for (const GLenum target : targets)
            UNCOUNTED(glEndQuery)(target);
        for (std::size_t i = 0; i < targets.size(); ++i) {
            GLuint result = 0; // OSMesa has no glGetQueryObjectui64v
            UNCOUNTED(glGetQueryObjectuiv)(_counting->queries[i], GL_QUERY_RESULT, &result);
            work.counts[i] = result;
        }
        GLint program = 0;
        nextFunction<void(GLenum, GLint*)>("glGetIntegerv")(GL_CURRENT_PROGRAM, &program);
        const auto known = _counting->programs.try_emplace(static_cast<GLuint>(program));
        ProgramCost& cost = known.first->second;
        if (known.second && program)
            cost = costOf(known.first->first);
        const std::uint64_t byVertices = cost.fetchesPerVertex * work.counts[DrawWork::ShadedVertices];
        work.counts[DrawWork::LeastTextureFetches] =
            byVertices + cost.fetchesPerFragment * work.counts[DrawWork::Fragments];
        work.counts[DrawWork::TextureFetches] =
            byVertices + cost.fetchesPerFragment * work.counts[DrawWork::ShadedFragments];
        _counting->counts.work[static_cast<std::size_t>(cost.part)].add(work);
    }

private:
    static constexpr std::array<GLenum, 6> targets = {
        GL_VERTICES_SUBMITTED_ARB,         GL_VERTEX_SHADER_INVOCATIONS_ARB,   GL_PRIMITIVES_SUBMITTED_ARB,
        GL_CLIPPING_OUTPUT_PRIMITIVES_ARB, GL_FRAGMENT_SHADER_INVOCATIONS_ARB, GL_SAMPLES_PASSED};
    Counting* _counting;
};

constexpr bool isDraw(GlCall kind) {
    return kind == GlCall::Draw || kind == GlCall::InstancedDraw || kind == GlCall::MultiDraw;
}

/// @tparam Data place of an argument, and so on.
template <std::size_t Data, std::size_t Width, std::size_t Height, std::size_t Format, class Arguments>
std::uint64_t imageBytes(const Arguments& all, GLsizei depth = 1) {
    return std::get<Data>(all)
               ? osg::Image::computeImageSizeInBytes(std::get<Width>(all), std::get<Height>(all), depth,
                                                     std::get<Format>(all), std::get<Format + 1>(all))
               : 0;
}

/// Bytes that a call uploads.
template <Function Called, class... Arguments>
std::uint64_t bytesOf(Arguments... arguments) {
    [[maybe_unused]] const std::tuple all(arguments...);
    using F = Function;
    if constexpr (Called == F::glBufferData || Called == F::glBufferStorage)
        return std::get<2>(all) ? std::get<1>(all) : 0;
    else if constexpr (Called == F::glBufferSubData)
        return std::get<2>(all);
    else if constexpr (Called == F::glMapBufferRange)
        return std::get<3>(all) & GL_MAP_WRITE_BIT ? std::get<2>(all) : 0;
    else if constexpr (Called == F::glTexImage2D)
        return imageBytes<8, 3, 4, 6>(all);
    else if constexpr (Called == F::glTexSubImage2D)
        return imageBytes<8, 4, 5, 6>(all);
    else if constexpr (Called == F::glTexImage3D)
        return imageBytes<9, 3, 4, 7>(all, std::get<5>(all));
    else if constexpr (Called == F::glTexSubImage3D)
        return imageBytes<10, 5, 6, 8>(all, std::get<7>(all));
    else if constexpr (Called == F::glMapBuffer) {
        GLint size = 0;
        UNCOUNTED(glGetBufferParameteriv)(std::get<0>(all), GL_BUFFER_SIZE, &size);
        return std::get<1>(all) == GL_READ_ONLY ? 0 : static_cast<std::uint64_t>(size);
    } else
        return 0;
}

template <Function, class Signature>
struct Counted;
template <Function Called, class Result, class... Arguments>
struct Counted<Called, Result(Arguments...)> {
    static inline std::atomic<Result (*)(Arguments...)> next =
        nullptr; ///< Contexts of several threads set it.

    static Result call(Arguments... arguments) {
        constexpr GlCall kind = kinds[static_cast<std::size_t>(Called)];
        const auto function = next.load(std::memory_order_relaxed);
        if (!counting)
            return function(arguments...);
        ++counting->counts.calls[static_cast<std::size_t>(kind)];
        (kind == GlCall::BufferUpload ? counting->counts.bufferBytes : counting->counts.textureBytes) +=
            bytesOf<Called>(arguments...);
        if constexpr (!isDraw(kind))
            return function(arguments...);
        const MeasuredDraw measured(*counting);
        return function(arguments...);
    }
    /// Calls `function` from now on. @return the function that counts.
    static void* replace(void* function) {
        next = reinterpret_cast<Result (*)(Arguments...)>(function);
        return function ? reinterpret_cast<void*>(&call) : nullptr;
    }
};

} // namespace

[[gnu::visibility("default")]] void* osg::getGLExtensionFuncPtr(const char* name) {
    using Replace = void* (*)(void*);
    static const std::unordered_map<std::string, Replace> replacements = {
#define CORE(...)
#define LATER(kind, name) {#name, &Counted<Function::name, decltype(::name)>::replace},
#include <examples/osgtreewind/bench/GlFunctions.def>
    };
    void* const function = nextExtension(name);
    const auto known = replacements.find(name);
    return known == replacements.end() ? function : known->second(function);
}

#define LATER(kind, name)
#define CORE(kind, name, result, parameters, arguments)                                                      \
    extern "C" result name parameters {                                                                      \
        using Call = Counted<Function::name, decltype(::name)>;                                              \
        [[maybe_unused]] static const bool isReplaced = Call::replace(dlsym(RTLD_NEXT, #name));              \
        return Call::call arguments;                                                                         \
    }
#include <examples/osgtreewind/bench/GlFunctions.def>

GlCounts countGlCalls(const std::function<void()>& run, bool withWork) {
    Counting here;
    here.withWork = withWork;
    counting = &here;
    run();
    counting = nullptr;
    return here.counts;
}
