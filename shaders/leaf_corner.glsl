// SPDX-License-Identifier: MIT
// A corner of a leaf card: of a record in a texture, or from vertex arrays of a host.
// HOST_ARRAYS: osg_Vertex: anchor, size; osg_Normal: corner in the leaf frame; osg_MultiTexCoord0: u, v, unit and
// reach, leaf; osg_MultiTexCoord1: rest orientation; osg_MultiTexCoord2: normal in the leaf frame, shade;
// osg_MultiTexCoord3: outward direction in the crown, shade.

struct LeafCorner {
    vec3 anchor;
    float size;
    vec4 orientation; // at rest, from the leaf frame to that of the tree
    vec3 corner;      // in the leaf frame
    vec3 normal;      // in the leaf frame
    vec2 coord;       // in the leaf texture
    float unit;       // unit and reach (instance.glsl)
    float leaf;       // index of the cluster in the full tree
    int card;         // number of the card in the full tree
    vec3 outward;     // in the crown
    vec2 shade;       // law/shade.glsl
};

#ifdef HOST_ARRAYS

LeafCorner leafCorner() {
    return LeafCorner(osg_Vertex.xyz, osg_Vertex.w, osg_MultiTexCoord1, osg_Normal, osg_MultiTexCoord2.xyz,
                      osg_MultiTexCoord0.xy, osg_MultiTexCoord0.z, osg_MultiTexCoord0.w, gl_VertexID >> 2,
                      osg_MultiTexCoord3.xyz, vec2(osg_MultiTexCoord2.w, osg_MultiTexCoord3.w));
}

#else

uniform sampler2D leafRecords; // addLeafRecords() in osgTreeWind/drawing/instanced/TreeGeometry.h
uniform vec3 leafCorners[12];  // of the three cards of a cluster
uniform vec3 leafNormals[3];

/// Place on the leaf texture (osgTreeWind/drawing/looks/LeafAtlas.h). @param onCard in [0, 1].
/// @param bough 1: a spray; 2 to 4: a bough, which is a card of all three.
vec2 leafCoordinate(int leaf, int card, int bough, vec2 onCard) {
    int variant = (leaf + card) % 3;
    if ((leaf * 7 + card * 5) / 3 % 2 == 1)
        onCard.x = 1.0 - onCard.x;
    if (bough == 1)
        return 0.5 * (vec2(variant & 1, variant >> 1) + onCard);
    int cell = bough == 2 ? variant & 1 : bough - 1;
    return 0.5 + 0.25 * (vec2(cell & 1, cell >> 1) + onCard);
}

LeafCorner leafCorner() {
    int card = gl_VertexID >> 2, corner = gl_VertexID & 3, record = treeTier() < 2 ? card / 3 : card;
    vec4 place = dataTexel(leafRecords, 4 * record), about = dataTexel(leafRecords, 4 * record + 2),
         more = dataTexel(leafRecords, 4 * record + 3);
    int leaf = int(more.z), bough = int(more.w), part = bough == 1 ? card % 3 : leaf % 3;
    vec2 onCard = vec2(corner == 1 || corner == 2, corner >= 2);
    return LeafCorner(place.xyz, place.w, dataTexel(leafRecords, 4 * record + 1), leafCorners[4 * part + corner],
                      leafNormals[part], leafCoordinate(leaf, bough == 1 ? part : 0, bough, onCard), about.w, more.z,
                      3 * leaf + part, about.xyz, more.xy);
}

#endif
