// surface_lookup in GLSL ES 3.00 (WebGL 2): codes and depths decide most sides, walks over the mesh the others.
//
// The mesh is drawn by `vertex` and `fragment` into two textures R32UI, cleared to 0, one column and one row larger
// than the image, without vertex attributes: three vertices a face of the tables. Depth test, both sides, no
// multisampling. Then three vertices are drawn over the image by `screen` and `lines`. Names are those of three.js.
//// vertex
precision highp float;
precision highp int;
uniform highp usampler2D faces;  // 4096 texels a row, two a face: corners, patch; twins, code << 24 | flag << 23 | kinds
uniform highp sampler2D points;  // 4096 texels a row: positions, as bones and morphs have moved them
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec2 size;  // of the image, px
flat out highp uint word;  // code << 24 | flag << 23 | face
out float nearness;

ivec2 at(int i) { return ivec2(i & 4095, i >> 12); }

void main() {
    int face = gl_VertexID / 3;
    int point = int(texelFetch(faces, at(2 * face), 0)[gl_VertexID - 3 * face]);
    word = (texelFetch(faces, at(2 * face + 1), 0).w & 0xff800000u) | uint(face);
    vec4 p_view = modelViewMatrix * texelFetch(points, at(point), 0);
    gl_Position = projectionMatrix * p_view;
    gl_Position.xy *= size / (size + 1.0);  // half a pixel more on every side
    // Of a parallel camera far - depth takes the place of 1/distance; z may run from -1 to 1, or from 1 to 0.
    float z = projectionMatrix[2][2] < 0.0 ? 1.0 - gl_Position.z : gl_Position.z;
    nearness = projectionMatrix[3][3] == 0.0 ? 1.0 : z / abs(projectionMatrix[2][2]);
}
//// fragment
precision highp float;
flat in highp uint word;
in float nearness;
layout(location = 0) out highp uint drawn;
layout(location = 1) out highp uint drawn_depth;

void main() { drawn = word, drawn_depth = floatBitsToUint(nearness * gl_FragCoord.w); }
//// screen of surface8
//// lines
precision highp float;
precision highp int;
uniform highp usampler2D codes, depths, faces;
uniform highp sampler2D points;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec2 size;
out vec4 line;

const uint nothing = 0xffffffffu, many = 0xfffffffbu;
const int arrived = 0, border = 1, other_line = 2, beyond = 3, lost = 4;

ivec2 at(int i) { return ivec2(i & 4095, i >> 12); }
uint word_at(ivec2 p) { return texelFetch(codes, p, 0).r; }
float q_at(ivec2 p) { return uintBitsToFloat(texelFetch(depths, clamp(p, ivec2(0), ivec2(size)), 0).r); }

/// A corner of a face, in the view and on the screen: 1/256 px along a walk and beside it, and 1/distance.
struct Corner { vec3 p_view; ivec2 place; float q; };

Corner corner_of(uint point, ivec2 from, ivec2 to) {
    vec4 p_view = modelViewMatrix * texelFetch(points, at(int(point)), 0);
    vec4 clip = projectionMatrix * p_view;
    ivec2 place = ivec2(floor(256.0 * 0.5 * (clip.xy / clip.w * size + size + 1.0) + 0.5)) - 256 * from - 128;
    bool is_down = to.x == 0;
    // Of a parallel camera as `nearness` above.
    float z = projectionMatrix[2][2] < 0.0 ? 1.0 - clip.z : clip.z;
    float q = projectionMatrix[3][3] == 0.0 ? 1.0 / clip.w : z / abs(projectionMatrix[2][2]);
    return Corner(p_view.xyz, is_down ? ivec2(place.y * to.y, place.x) : ivec2(place.x * to.x, place.y), q);
}

/// Which side of a face is seen.
float facing_of(Corner c[3]) {
    vec3 n = cross(c[1].p_view - c[0].p_view, c[2].p_view - c[0].p_view);
    return sign(projectionMatrix[3][3] == 0.0 ? dot(n, c[0].p_view) : -n.z);
}

/// Where a walk crosses an edge: px from its sample, and 1/distance there.
vec2 crossing_of(Corner a, Corner b) {
    float t = float(a.place.y) / float(a.place.y - b.place.y);
    return vec2((float(a.place.x) + t * float(b.place.x - a.place.x)) / 256.0, a.q + t * (b.q - a.q));
}

/// How a walk ended, where (as crossing_of), on which face, where it came to that, and over which edge it left it.
struct Walk { int end; vec2 left; uint face; vec2 entered; };

/// From the face at one sample along `to`, until the face `goal`, a line or past the next sample.
Walk walk(ivec2 from, ivec2 to, uint face, uint goal) {
    Walk walk = Walk(lost, vec2(0), face, vec2(0));
    Corner c[3];
    uvec4 corners = texelFetch(faces, at(2 * int(face)), 0);
    for (int i = 0; i < 3; ++i) c[i] = corner_of(corners[i], from, to);
    int leaves = -1, count = 0;
    for (int i = 0; i < 3; ++i) {
        int k = (i + 1) % 3;
        if ((c[i].place.y > 0) == (c[k].place.y > 0)) continue;
        vec2 found = crossing_of(c[i], c[k]);
        bool is_last = count == 0 || found.x > walk.left.x;
        if (is_last) walk.entered = walk.left, walk.left = found, leaves = i;
        else walk.entered = found;
        ++count;
    }
    if (count != 2) return walk;
    float facing = facing_of(c);
    for (int step = 0; step < 64; ++step) {
        if (walk.left.x > 1.0 + 1.0 / 256.0) {
            walk.end = beyond;
            return walk;
        }
        uvec4 rest = texelFetch(faces, at(2 * int(walk.face) + 1), 0);
        uint twin = rest[leaves];
        if (twin == many) return walk;
        uint next = (twin & 0x3ffffffcu) >> 2;
        int edge = int(twin & 3u);
        float facing_next = 0.0;
        if (twin != nothing) {
            corners = texelFetch(faces, at(2 * int(next)), 0);
            for (int i = 0; i < 3; ++i) c[i] = corner_of(corners[i], from, to);
            facing_next = facing_of(c);
        }
        bool is_open = facing != 0.0 && facing_next == ((twin & 0x80000000u) != 0u ? -facing : facing);
        uint kind = rest.w >> (3 * leaves) & 7u;
        if (twin == nothing || !is_open || kind != 0u) {
            walk.end = twin == nothing ? border : other_line;
            return walk;
        }
        walk.face = next;
        walk.end = next == goal ? arrived : lost;
        if (next == goal) return walk;
        facing = facing_next;
        bool is_high = c[(edge + 2) % 3].place.y > 0;
        leaves = (edge + (is_high == (c[edge].place.y > 0) ? 1 : 2)) % 3;
        walk.entered = walk.left;
        walk.left = crossing_of(c[leaves], c[(leaves + 1) % 3]);
    }
    return walk;
}

/// Whether the surface of a walk goes on to the next sample, no farther off than what is seen there.
bool goes_on(Walk walk, float q_seen) {
    if (walk.end != beyond) return false;
    float length_px = walk.left.x - walk.entered.x;
    float share = length_px > 0.0 ? (1.0 - walk.entered.x) / length_px : 0.0;
    float q = mix(walk.entered.y, walk.left.y, share);
    return q >= q_seen * (1.0 - 1e-5);
}

uint patch_of(uint face) { return texelFetch(faces, at(2 * int(face)), 0).w; }

/// Whether the mesh has a line between two samples.
bool is_found(ivec2 p, ivec2 to, uint a, uint b) {
    Walk walks[2];
    for (int i = 0; i < 2; ++i) {  // there, and back
        walks[i] = walk(i == 0 ? p : p + to, i == 0 ? to : -to, i == 0 ? a : b, i == 0 ? b : a);
        if (walks[i].end == arrived) return false;
    }
    Walk there = walks[0], back = walks[1];
    if ((there.end == lost || back.end == lost) && patch_of(a) == patch_of(b)) return false;
    if (goes_on(there, q_at(p + to)) || goes_on(back, q_at(p))) return false;
    bool is_crack = there.end == border && back.end == border && abs(there.left.x + back.left.x - 1.0) <= 1.0 / 64.0 &&
        abs(there.left.y - back.left.y) <= 1e-4 * there.left.y;
    return !is_crack;
}

bool is_line(ivec2 p, ivec2 to) {
    uint a = word_at(p), b = word_at(p + to);
    if (a == b) return false;
    if (a == 0u || b == 0u) return true;
    float q_a = q_at(p), q_b = q_at(p + to), jump = q_b - q_a;
    float bend_a = abs(jump - (q_a - q_at(p - to))), bend_b = abs(jump - (q_at(p + 2 * to) - q_b));
    // As much as a pixel is wide, a tenth of it.
    float least = 0.2 / (size.y * projectionMatrix[1][1]) * (projectionMatrix[3][3] == 0.0 ? max(q_a, q_b) : 1.0);
    int apart = abs(int(a >> 24) - int(b >> 24));
    bool is_flagged = ((a | b) & 0x800000u) != 0u;
    if (apart >= 4 && !is_flagged && max(bend_a, bend_b) > least) return true;
    if (apart < 2 && !is_flagged && min(bend_a, bend_b) <= least) return false;
    return is_found(p, to, a & 0x7fffffu, b & 0x7fffffu);
}

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    bool is_any = false;
    for (int i = 0; i < 4 && !is_any; ++i) {  // a loop, or each walk stands here eight times
        ivec2 to = ivec2(1 - (i & 1), i & 1);
        is_any = is_line(i < 2 ? p : p + 1 - to, to);
    }
    line = vec4(is_any);
}
