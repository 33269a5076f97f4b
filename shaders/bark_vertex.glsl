// SPDX-License-Identifier: MIT
// A vertex of bark: packed by makePackedBark() (osgTreeWind/drawing/instanced/TreeGeometry.h), or from vertex arrays of
// a host.
// HOST_ARRAYS: osg_Vertex: centre, radius; osg_Normal: outward; osg_MultiTexCoord0: u, v, unit and reach;
// osg_MultiTexCoord1: shade.

struct BarkVertex {
    vec3 centre; // on the centre line of the branch
    float radius;
    vec3 outward;
    vec2 coord; // u (0 to 2 around), v
    float unit; // unit and reach (instance.glsl)
    vec2 shade; // law/shade.glsl
};

#ifdef HOST_ARRAYS

BarkVertex barkVertex() {
    return BarkVertex(osg_Vertex.xyz, osg_Vertex.w, osg_Normal, osg_MultiTexCoord0.xy, osg_MultiTexCoord0.z,
                      osg_MultiTexCoord1.xy);
}

#else

layout(location = 10) in uvec4 barkPlace; // 16 bits each: centre, root of the radius; 12, 12, 8: outward, u; unit
layout(location = 11) in uvec2 barkShares; // 24 bits each: shade; 8: halves of v
uniform vec3 barkLow, barkSize;           // box of the centres, m
uniform vec2 barkMost;                    // radius, m; v

/// Some bits of a word, as a share of their largest value.
float share(uint word, int first, int most) { return float(int(word >> first) & most) * (1.0 / float(most)); }

/// The unit vector at a place in [-1, 1] on an unfolded octahedron.
vec3 onOctahedron(vec2 place) {
    float z = 1.0 - abs(place.x) - abs(place.y), below = max(-z, 0.0);
    return normalize(vec3(place.x + (place.x < 0.0 ? below : -below), place.y + (place.y < 0.0 ? below : -below), z));
}

BarkVertex barkVertex() {
    vec3 centre = vec3(share(barkPlace.x, 0, 65535), share(barkPlace.x, 16, 65535), share(barkPlace.y, 0, 65535));
    float radius = share(barkPlace.y, 16, 65535);
    vec2 outward = vec2(share(barkPlace.z, 0, 4095), share(barkPlace.z, 12, 4095));
    uint v = (barkShares.x & 255u) << 8 | barkShares.y & 255u;
    return BarkVertex(barkLow + barkSize * centre, barkMost.x * radius * radius, onOctahedron(2.0 * outward - 1.0),
                      vec2(float(barkPlace.z >> 24) * (2.0 / 240.0), barkMost.y * share(v, 0, 65535)),
                      uintBitsToFloat(barkPlace.w), vec2(barkShares >> 8) * (1.0 / 16777216.0));
}

#endif
