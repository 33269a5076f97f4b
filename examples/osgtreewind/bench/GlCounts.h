// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <numeric>

/// Kinds of OpenGL calls.
enum class GlCall {
    Draw,
    InstancedDraw, ///< Also one indirect draw.
    MultiDraw,
    Program,
    Texture, ///< Bindings, and selections of a texture unit.
    Buffer,
    VertexArray,
    Uniform,
    Attribute, ///< Layout of vertices.
    State,     ///< Modes, matrices, lights, materials, framebuffers.
    BufferUpload,
    TextureUpload,
    Query, ///< Reads of state, and of errors.
    Other  ///< Objects made, changed or deleted; clears and flushes.
};
constexpr std::array glCallNames = {"draws",         "instancedDraws", "multiDraws", "programs",   "textures",
                                    "buffers",       "vertexArrays",   "uniforms",   "attributes", "state",
                                    "bufferUploads", "textureUploads", "queries",    "other"};

/// What programs draw, by their uniforms.
enum class DrawnPart { Leaves, Bark, Pictures, Poses, Other };
constexpr std::array drawnPartNames = {"leaves", "bark", "impostors", "poses", "other"};

/// Work of draws: results of GL_ARB_pipeline_statistics_query, and texture fetches computed from them.
struct DrawWork {
    enum Count {
        Vertices, ///< As submitted.
        ShadedVertices,
        Primitives,
        ClippedPrimitives, ///< Left by clipping.
        ShadedFragments,
        Fragments,           ///< Left by tests and shaders.
        LeastTextureFetches, ///< Shaded vertices and `Fragments`, times textureFetches() of their shaders.
        TextureFetches       ///< The same with `ShadedFragments`.
    };
    static constexpr std::array names = {
        "vertices",        "shadedVertices", "primitives",          "clippedPrimitives",
        "shadedFragments", "fragments",      "leastTextureFetches", "textureFetches"};
    std::uint64_t draws = 0;
    std::array<std::uint64_t, names.size()> counts{};
    void add(const DrawWork& other) {
        draws += other.draws;
        for (std::size_t i = 0; i < counts.size(); ++i)
            counts[i] += other.counts[i];
    }
};

/// Calls that were counted.
struct GlCounts {
    std::array<std::uint64_t, glCallNames.size()> calls{};
    std::uint64_t bufferBytes = 0, textureBytes = 0;    ///< Uploaded, or mapped for writing.
    std::array<DrawWork, drawnPartNames.size()> work{}; ///< By part.

    std::uint64_t of(GlCall kind) const { return calls[static_cast<std::size_t>(kind)]; }
    std::uint64_t allCalls() const { return std::accumulate(calls.begin(), calls.end(), std::uint64_t(0)); }
};

/// Runs a function and counts the OpenGL calls of the process meanwhile, without glFinish(), glGetString()
/// and the functions of query objects. No other thread may use OpenGL.
/// @param withWork also fill in `work`, by queries around each draw. The context must support
/// GL_ARB_pipeline_statistics_query.
GlCounts countGlCalls(const std::function<void()>& run, bool withWork = false);
