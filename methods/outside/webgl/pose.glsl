// Points and faces of the tables in a pose, in GLSL ES 3.00 (WebGL 2).
//
// `screen` draws three vertices with `points` into RGBA32F, then, with these, `faces` into RGBA32UI: tables as the methods
// read them, of 4096 texels a row.
//// screen of surface8
//// points
precision highp float;
precision highp int;
uniform highp sampler2D rest;  // a texel a point: position, its first term; after the points their terms
uniform highp sampler2D pose;  // matrices by columns, and weights of morphs
layout(location = 0) out highp vec4 p_world;

ivec2 at(int i) { return ivec2(i & 4095, i >> 12); }

vec4 four_at(int i) { return texelFetch(pose, at(i), 0); }

vec3 moved(float matrix, vec3 p) {
    int i = 4 * int(matrix);
    return (mat4(four_at(i), four_at(i + 1), four_at(i + 2), four_at(i + 3)) * vec4(p, 1)).xyz;
}

void main() {
    int point = int(gl_FragCoord.x) + 4096 * int(gl_FragCoord.y);
    vec4 own = texelFetch(rest, at(point), 0);
    int end = int(texelFetch(rest, at(point + 1), 0).w);
    p_world = vec4(0, 0, 0, 1);
    for (int i = int(own.w); i < end; ++i) {
        vec4 term = texelFetch(rest, at(i), 0);
        int weight = -1 - int(term.w);
        if (term.w < 0.0) own.xyz += four_at(weight >> 2)[weight & 3] * term.xyz;  // morphs come first
        else p_world.xyz += term.y * moved(term.x, own.xyz) + term.w * moved(term.z, own.xyz);
    }
}
//// faces
precision highp float;
precision highp int;
uniform highp usampler2D faces;
uniform highp sampler2D points;
uniform float least_cosine;  // of edges that are no creases
layout(location = 0) out highp uvec4 drawn;

const uint many = 0xfffffffbu, flag = 0x800000u, object = 0x7ffe00u, crease = 3u, seam = 5u;

ivec2 at(int i) { return ivec2(i & 4095, i >> 12); }
vec3 point_at(uint i) { return texelFetch(points, at(int(i)), 0).xyz; }

/// As long as two times its area.
vec3 normal_of(int face) {
    uvec4 corners = texelFetch(faces, at(2 * face), 0);
    vec3 p = point_at(corners.x);
    return cross(point_at(corners.y) - p, point_at(corners.z) - p);
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    drawn = texelFetch(faces, texel, 0);
    if ((texel.x & 1) == 0) return;
    uvec3 twins = drawn.xyz;
    uint rest = drawn.w & ~flag;
    vec3 normal = normal_of((texel.x + 4096 * texel.y) / 2);
    for (int i = 0; i < 3; ++i) {
        uint twin = twins[i];
        if (twin == many) rest |= flag;
        if (twin >= many) continue;
        int face = int((twin & 0x3ffffffcu) >> 2);
        uint other = texelFetch(faces, at(2 * face + 1), 0).w;
        vec3 next = (twin & 0x80000000u) != 0u ? -normal_of(face) : normal_of(face);
        float least = length(normal) * length(next), fold = dot(normal, next) - least_cosine * least;
        // What floats cannot tell stays as in the tables.
        bool is_crease = abs(fold) > 1e-5 * least ? fold < 0.0 : (rest >> 3 * i & 7u) == crease;
        uint kind = is_crease ? crease : ((rest ^ other) & object) != 0u ? seam : 0u;
        rest = rest & ~(7u << 3 * i) | kind << 3 * i;
        // What codes do not tell is looked up.
        if ((kind != 0u) != (abs(int(rest >> 24) - int(other >> 24)) >= 2)) rest |= flag;
    }
    drawn.w = rest;
}
