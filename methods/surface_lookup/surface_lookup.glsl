// surface_lookup in GLSL ES 3.00 (WebGL 2): codes and depths decide most sides, walks over the mesh the others.
//
// The mesh is drawn by `vertex` and `fragment` into two textures R32UI, cleared to 0, one column and one row larger
// than the image, without vertex attributes: three vertices a face of the tables. Depth test, both sides, no
// multisampling. Then `screen` draws three vertices with `marks` into R8UI of that size; `tiles`, a vertex for each 4 x 4
// px, draws points with `sides` into the same, cleared to 0, where marks ask for it; and `screen` or `tiles` draws
// `lines` over the image. Names are those of three.js.
//// vertex
precision highp float;
precision highp int;
uniform highp usampler2D faces;  // 4096 texels a row, two a face: corners, patch; twins, code << 24 | flag << 23 | object << 9 | kinds
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
//// tiles
uniform highp usampler2D marks;
uniform vec2 target_size;  // px of what is drawn into

/// Points that cover all that what is marked reaches.
void main() {
    ivec2 reach = textureSize(marks, 0) - ivec2(target_size);
    int columns = (int(target_size.x) + 3) / 4;
    ivec2 first = 4 * ivec2(gl_VertexID % columns, gl_VertexID / columns);
    uint most = 0u;
    for (int y = 0; y < 4 + reach.y; ++y)
        for (int x = 0; x < 4 + reach.x; ++x) most = max(most, texelFetch(marks, first + ivec2(x, y), 0).r);
    bool is_drawn = most >= (reach.x == 0 ? 4u : 1u);
    vec2 middle = min(vec2(first) + 2.0, target_size);
    gl_Position = vec4(is_drawn ? 2.0 * middle / target_size - 1.0 : vec2(2), 0, 1);
    gl_PointSize = 4.0;
}
//// marks
//-- judging
precision highp float;
precision highp int;
uniform highp usampler2D codes, depths;
uniform mat4 projectionMatrix;
uniform vec2 size;

const int no_line = 0, sure_line = 1, doubt = 2;
const bool has_classes = false;  // as it stands in the other passes, too

uint word_at(ivec2 p) { return texelFetch(codes, p, 0).r; }
float q_at(ivec2 p) { return uintBitsToFloat(texelFetch(depths, clamp(p, ivec2(0), ivec2(size)), 0).r); }

/// What codes and depths tell of a side, from its four samples in a row.
int told_of(uint a, uint b, float q_before, float q_a, float q_b, float q_after) {
    float jump = q_b - q_a, bend_a = abs(jump - (q_a - q_before)), bend_b = abs(jump - (q_after - q_b));
    // As much as a pixel is wide, a tenth of it.
    float least = 0.2 / (size.x * projectionMatrix[0][0]) * (projectionMatrix[3][3] == 0.0 ? max(q_a, q_b) : 1.0);
    int apart = abs(int(a >> 24) - int(b >> 24));
    bool is_flagged = ((a | b) & 0x800000u) != 0u;
    if (a == b) return no_line;
    if (a == 0u || b == 0u || (apart >= 4 && !is_flagged && max(bend_a, bend_b) > least)) return sure_line;
    return apart < 2 && !is_flagged && min(bend_a, bend_b) <= least ? no_line : doubt;
}

/// The same of a sample's sides to the next column and the next row.
ivec2 told_at(ivec2 p) {
    ivec2 x = ivec2(1, 0), y = ivec2(0, 1), last = ivec2(size);
    uint a = word_at(p), b = p.x < last.x ? word_at(p + x) : a, c = p.y < last.y ? word_at(p + y) : a;
    if (a == b && a == c) return ivec2(no_line);
    float q = q_at(p);
    return ivec2(told_of(a, b, q_at(p - x), q, q_at(p + x), q_at(p + 2 * x)),
                 told_of(a, c, q_at(p - y), q, q_at(p + y), q_at(p + 2 * y)));
}
//-- end
out highp uint drawn;  // 1: a line to the next column, 2: to the next row, 4: look up

void main() {
    ivec2 told = told_at(ivec2(gl_FragCoord.xy));
    drawn = uint(told.x & 1 | (told.y & 1) << 1 | ((told.x | told.y) & doubt) << 1);
    if (has_classes && drawn != 0u) drawn = 4u;
}
//// sides
const bool notes_lines = false;  // a walk ends at the first line
//-- judging of surface_lookup
//-- walks
uniform highp usampler2D faces;
uniform highp sampler2D points;
uniform mat4 modelViewMatrix;

const uint nothing = 0xffffffffu, many = 0xfffffffbu;
const int arrived = 0, border = 1, other_line = 2, beyond = 3, cut = 4, fork = 5, lost = 6, flat_fork = 7;
const uint contour = 1u, boundary = 2u, crease = 3u, intersection = 4u, seam = 5u;  // classes

ivec2 at(int i) { return ivec2(i & 4095, i >> 12); }

/// A corner of a face in the view, and on the screen times w, which holds behind the eye, too: 1/256 px along a walk
/// and beside it, w, and 1/distance.
struct Corner { vec3 p_view; vec4 h; };

Corner corner_of(uint point, ivec2 from, ivec2 to) {
    vec4 p_view = modelViewMatrix * texelFetch(points, at(int(point)), 0);
    vec4 clip = projectionMatrix * p_view;
    vec2 place = 128.0 * (clip.xy * size + clip.w * (size + 1.0));
    vec2 start = vec2(256 * from + 128);
    bool is_on_screen = max(abs(clip.x), abs(clip.y)) < 1e3 * clip.w;
    place = is_on_screen ? clip.w * (floor(place / clip.w + 0.5) - start) : place - clip.w * start;
    // Of a parallel camera as `nearness` above.
    float z = projectionMatrix[2][2] < 0.0 ? 1.0 - clip.z : clip.z;
    float q = projectionMatrix[3][3] == 0.0 ? 1.0 : z / abs(projectionMatrix[2][2]);
    return Corner(p_view.xyz, vec4(dot(place, vec2(to)), to.x == 0 ? place.x : place.y, clip.w, q));
}

/// Which side of a face is seen.
float facing_of(Corner c[3]) {
    vec3 n = cross(c[1].p_view - c[0].p_view, c[2].p_view - c[0].p_view);
    return sign(projectionMatrix[3][3] == 0.0 ? dot(n, c[0].p_view) : -n.z);
}

/// Where a walk crosses an edge: px from its sample, and 1/distance there; 0 behind the eye.
vec2 crossing_of(Corner a, Corner b) {
    vec4 h = a.h + a.h.y / (a.h.y - b.h.y) * (b.h - a.h);
    return h.z > 0.0 ? vec2(h.x / 256.0, h.w) / h.z : vec2(h.x > 0.0 ? 1e9 : -1e9, 0);
}

/// How a walk ended, where (as crossing_of), on which face, and where it came to that; the class of the last line; where
/// lines are noted, the last four, the newest first, and 1/distance at `asked`, below 0 if it did not come there.
struct Walk { int end; vec2 left; uint face; vec2 entered; uint kind; uvec4 lines; float q_asked; };

/// 1/distance of the last face at s px from the walk's sample.
float q_on(Walk walk, float s) {
    float length_px = walk.left.x - walk.entered.x;
    return mix(walk.entered.y, walk.left.y, length_px > 0.0 ? (s - walk.entered.x) / length_px : 0.0);
}

/// `of_class`: a line as one of a class; an edge tells its own.
#ifdef NAMES_EDGES
const uint most_place = 127u, no_edge = 0xffffff80u;
uint of_class(uint line, uint kind) { return line; }
#else
const uint most_place = 255u, no_edge = 0xff00u;
uint of_class(uint line, uint kind) { return has_classes && line != 0u ? line & 0xffffu | kind << 16 : line; }
#endif
uint place_of(float s) { return uint(float(most_place) * clamp(s, 0.0, 1.0) + 0.5); }

/// A line: an edge of a face and its place in 1/127; or in 16 bits, a name of the edge that its corners give, 1 to
/// 254, and its place in 1/255.
uint line_word(uint edge, uvec2 corners, float s) {
#ifdef NAMES_EDGES
    return edge << 7 | place_of(s);
#else
    uint name = 1u + (((corners.x + corners.y) * 0x9e3779b1u ^ corners.x * corners.y * 0x85ebca6bu) >> 16) % 254u;
    return name << 8 | place_of(s);
#endif
}

/// From the face at one sample along `to`, until the face `goal`, a line or past the next sample.
Walk walk(ivec2 from, ivec2 to, uint face, uint goal, float asked) {
    Walk walk = Walk(lost, vec2(0), face, vec2(0), 0u, uvec4(0), -1.0);
    Corner c[3];
    uvec4 corners = texelFetch(faces, at(2 * int(face)), 0);
    for (int i = 0; i < 3; ++i) c[i] = corner_of(corners[i], from, to);
    int leaves = -1, count = 0;
    for (int i = 0; i < 3; ++i) {
        int k = (i + 1) % 3;
        if ((c[i].h.y > 0.0) == (c[k].h.y > 0.0)) continue;
        vec2 found = crossing_of(c[i], c[k]);
        bool is_last = count == 0 || found.x > walk.left.x;
        if (is_last) walk.entered = walk.left, walk.left = found, leaves = i;
        else walk.entered = found;
        ++count;
    }
    if (count != 2) return walk;
    float facing = facing_of(c);
    for (int step = 0; step < 64; ++step) {
        if (notes_lines && walk.q_asked < 0.0 && walk.left.x >= asked) walk.q_asked = q_on(walk, asked);
        if (walk.left.x > 1.0 + 1.0 / 256.0) {
            walk.end = walk.left.y > 0.0 ? beyond : cut;
            return walk;
        }
        uvec4 rest = texelFetch(faces, at(2 * int(walk.face) + 1), 0);
        uint twin = rest[leaves];
        uint next = (twin & 0x3ffffffcu) >> 2;
        int edge = int(twin & 3u);
        bool is_two = twin != nothing && twin != many;
        uint kind = rest.w >> (3 * leaves) & 7u;
        uint named = is_two ? min(next << 2 | uint(edge), walk.face << 2 | uint(leaves)) : walk.face << 2 | uint(leaves);
        uvec2 ends = uvec2(corners[leaves], corners[(leaves + 1) % 3]);
        uint noted = notes_lines ? line_word(named, ends, walk.left.x) : 0u;
        float facing_next = 0.0;
        if (is_two) {
            corners = texelFetch(faces, at(2 * int(next)), 0);
            for (int i = 0; i < 3; ++i) c[i] = corner_of(corners[i], from, to);
            facing_next = facing_of(c);
        }
        bool is_open = is_two && facing != 0.0 && facing_next == ((twin & 0x80000000u) != 0u ? -facing : facing);
        if (!is_open || kind != 0u) {
            walk.kind = is_open ? kind : twin == nothing ? boundary : contour;
            if (notes_lines) walk.lines = uvec4(of_class(noted, walk.kind), walk.lines.xyz);
            if (!is_open || !notes_lines) {
                // Of many faces the next one round the edge may go on flat on the side that is seen.
                bool is_flat = (kind & (facing < 0.0 ? 1u : 2u)) != 0u;
                walk.end = twin == many ? (is_flat ? flat_fork : fork) : twin == nothing ? border : other_line;
                return walk;
            }
        }
        walk.face = next;
        walk.end = next == goal ? arrived : lost;
        if (next == goal) return walk;
        facing = facing_next;
        bool is_high = c[(edge + 2) % 3].h.y > 0.0;
        leaves = (edge + (is_high == (c[edge].h.y > 0.0) ? 1 : 2)) % 3;
        walk.entered = walk.left;
        walk.left = crossing_of(c[leaves], c[(leaves + 1) % 3]);
    }
    return walk;
}

bool may_go_on(Walk walk) { return walk.end == border || walk.end == flat_fork; }
bool is_at_line(Walk walk) { return may_go_on(walk) || walk.end == other_line || walk.end == fork; }

/// Whether nothing is known of the way between the ends of two walks.
bool is_lost(Walk there, Walk back) { return max(there.end, back.end) == lost || min(there.end, back.end) >= lost; }

/// Whether the surface of a walk goes on to the next sample, no farther off than what is seen there.
bool goes_on(Walk walk, float q_seen) { return walk.end == beyond && q_on(walk, 1.0) >= q_seen * (1.0 - 4e-6); }

uint patch_of(uint face) { return texelFetch(faces, at(2 * int(face)), 0).w; }
uint object_of(uint face) { return texelFetch(faces, at(2 * int(face) + 1), 0).w >> 9 & 0x3fffu; }

vec3 normal_of(uint face) {
    uvec4 corners = texelFetch(faces, at(2 * int(face)), 0);
    vec3 p = texelFetch(points, at(int(corners.x)), 0).xyz;
    return normalize(cross(texelFetch(points, at(int(corners.y)), 0).xyz - p, texelFetch(points, at(int(corners.z)), 0).xyz - p));
}

/// Whether borders that ended two walks are both sides of a crack, flatter than a crease of 40 degrees.
bool is_crack(Walk there, Walk back) {
    return may_go_on(there) && may_go_on(back) &&
        abs(there.left.x + back.left.x - 1.0) <= 1.0 / 64.0 && abs(there.left.y - back.left.y) <= 1e-4 * there.left.y &&
        abs(dot(normal_of(there.face), normal_of(back.face))) > 0.766;
}
//-- end
out highp uint drawn;  // lines as in marks; with classes that to the next column, and times 8 that to the next row

/// The class of the nearer of the lines that ended two walks, or of surfaces that meet.
uint nearer_of(Walk there, Walk back) {
    bool is_first = is_at_line(there) && (back.end != beyond || there.left.y >= q_on(back, 1.0 - there.left.x) * (1.0 - 1e-5));
    bool is_second = is_at_line(back) && (there.end != beyond || back.left.y >= q_on(there, 1.0 - back.left.x) * (1.0 - 1e-5));
    if (there.end == fork && back.end == fork) return crease;
    if (is_first && is_second) return there.left.y >= back.left.y ? there.kind : back.kind;
    return is_first ? there.kind : is_second ? back.kind : intersection;
}

/// The class of the line that the mesh has between two samples, 0 without one.
uint found_between(ivec2 p, ivec2 to) {
    uint a = word_at(p), b = word_at(p + to), face_a = a & 0x7fffffu, face_b = b & 0x7fffffu;
    bool is_sky = has_classes && (a == 0u || b == 0u);
    Walk there, back;
    for (int i = 0; i < 2; ++i) {
        if (has_classes && (i == 0 ? a : b) == 0u) continue;
        back = walk(i == 0 ? p : p + to, i == 0 ? to : -to, i == 0 ? face_a : face_b,
                    is_sky ? nothing : i == 0 ? face_b : face_a, 0.0);
        if (back.end == arrived) return 0u;
        if (i == 0) there = back;
    }
    if (is_sky) return is_at_line(back) ? back.kind : contour;
    if (is_lost(there, back) && patch_of(face_a) == patch_of(face_b)) return 0u;
    // Of two objects the border of one on the other, and a crack between them, are seams.
    bool are_two = object_of(face_a) != object_of(face_b);
    bool goes_there = goes_on(there, q_at(p + to)), goes_back = goes_on(back, q_at(p));
    if (goes_there || goes_back) return are_two && min(there.end, back.end) <= other_line ? seam : 0u;
    if (there.end == cut || back.end == cut) return min(there.end, back.end) <= other_line ? contour : 0u;
    if (is_crack(there, back)) return are_two ? seam : 0u;
    return has_classes ? nearer_of(there, back) : contour;
}

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy), told = told_at(p);
    drawn = 0u;
    // A loop over those in doubt, with classes over all, or each walk stands here four times.
    ivec2 asked = has_classes ? ivec2(notEqual(told, ivec2(no_line))) : told >> 1;
    for (uint todo = uint(asked.x | asked.y << 1); todo != 0u; todo &= todo - 1u) {
        bool is_across = (todo & 1u) != 0u;
        uint found = found_between(p, is_across ? ivec2(1, 0) : ivec2(0, 1));
        if (has_classes && (is_across ? told.x : told.y) == sure_line) found = max(found, contour);
        if (!has_classes) found = min(found, 1u);
        drawn |= is_across ? found : has_classes ? found << 3 : found << 1;
    }
}
//// lines
const bool has_classes = false;
uniform highp usampler2D marks, sides;
out highp vec4 line;

uint lines_at(ivec2 p) { return texelFetch(marks, p, 0).r | texelFetch(sides, p, 0).r; }

/// The lower number of two classes, 0 if there is none.
uint first_of(uint a, uint b) { return a == 0u || (b != 0u && b < a) ? b : a; }

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy), x = ivec2(1, 0), y = ivec2(0, 1);
    if (has_classes) {
        uint own = texelFetch(sides, p, 0).r, above = texelFetch(sides, p + y, 0).r, right = texelFetch(sides, p + x, 0).r;
        uint kind = first_of(first_of(own & 7u, own >> 3), first_of(above & 7u, right >> 3));
        line = vec4(kind != 0u, float(kind) / 255.0, 0, 0);
        return;
    }
    uint lines = lines_at(p) | lines_at(p + y) & 1u | lines_at(p + x) & 2u;
    line = vec4((lines & 3u) != 0u);
}
