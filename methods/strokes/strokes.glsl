// strokes in GLSL ES 3.00 (WebGL 2): as chords, but a piece of a line is its edge, clipped to the cell.
//
// As chords is drawn, but `sides` into RGBA32UI; `cells` reads codes, depths and the tables, too, and has a second target
// RGBA32UI, `exits`. Then `screen` draws `ways` into RGBA32UI, four texels for 8 x 4 px; `spread` draws `thin` into RGBA8 of
// the frame, cleared to 0, three vertices a texel of `ways`, the greatest of what is drawn; and `lines` read that, too.
//// vertex of surface_lookup
//// fragment of surface_lookup
//// screen of surface8
//// tiles of surface_lookup
//// marks of chords
//// sides
#define NAMES_EDGES
const bool notes_lines = true;
//-- judging of surface_lookup
//-- walks of surface_lookup
//-- between of chords
//// cells
//-- edges
precision highp float;
precision highp int;
uniform highp usampler2D sides, codes, depths, faces;
uniform highp sampler2D points;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec2 size;

const bool has_classes = false;
const float at_corner_px = 0.02;

ivec2 at(int i) { return ivec2(i & 4095, i >> 12); }

/// Of a face: corners and patch; twins, code, object and kinds.
uvec4 corners_of(uint face) { return texelFetch(faces, at(2 * int(face)), 0); }
uvec4 rest_of(uint face) { return texelFetch(faces, at(2 * int(face) + 1), 0); }

uvec2 points_of(uint edge) {
    uvec4 corners = corners_of(edge >> 2);
    return uvec2(corners[edge & 3u], corners[((edge & 3u) + 1u) % 3u]);
}

/// Of a point: x and y in the cell p times w, 1/distance times w, and w.
vec4 seen(uint point, ivec2 p) {
    vec4 clip = projectionMatrix * (modelViewMatrix * texelFetch(points, at(int(point)), 0));
    float z = projectionMatrix[2][2] < 0.0 ? 1.0 - clip.z : clip.z;
    float q = projectionMatrix[3][3] == 0.0 ? 1.0 : z / abs(projectionMatrix[2][2]);
    return vec4(0.5 * (clip.xy * size + clip.w * size) - clip.w * vec2(p), q, clip.w);
}

/// A face's plane: 1/distance of it by x, by y and at the first corner of the cell p.
vec3 plane_of(uint face, ivec2 p) {
    uvec4 corners = corners_of(face);
    vec4 a = seen(corners.x, p), b = seen(corners.y, p), c = seen(corners.z, p);
    return vec3(a.z, b.z, c.z) * inverse(mat3(a.xyw, b.xyw, c.xyw));
}

/// What lies in the cell of what is straight between two places in it, as parts of its length; none if y is not above x.
vec2 clipped(vec2 a, vec2 b) {
    vec2 part = vec2(0, 1), way = b - a;
    for (int axis = 0; axis < 2; ++axis) {
        if (abs(way[axis]) < 1e-6) continue;
        vec2 t = (vec2(0, 1) - a[axis]) / way[axis];
        part = vec2(max(part.x, min(t.x, t.y)), min(part.y, max(t.x, t.y)));
    }
    return part;
}

/// The four sides of a cell: below, right, above, left, as rows go up; lines of each.
ivec2 first_of(int side) { return ivec2(side == 1, side == 2); }
ivec2 along_of(int side) { return (side & 1) == 0 ? ivec2(1, 0) : ivec2(0, 1); }
uvec2 lines_of[4];

void read_sides(ivec2 p) {
    uvec4 own = texelFetch(sides, p, 0);
    lines_of = uvec2[4](own.xy, texelFetch(sides, p + ivec2(1, 0), 0).zw, texelFetch(sides, p + ivec2(0, 1), 0).xy, own.zw);
}

vec4 away_from_sides(vec2 place) { return abs(vec4(place.y, place.x - 1.0, place.y - 1.0, place.x)); }
int nearest_side(vec4 away) {
    float least = min(min(away.x, away.y), min(away.z, away.w));
    return away.x == least ? 0 : away.y == least ? 1 : away.z == least ? 2 : 3;
}

/// Whether samples tell that an edge goes on where it leaves a cell, and if that is a corner, where it may leave either way.
bvec2 is_known(vec2 place, uint edge) {
    vec4 away = away_from_sides(place);
    int near = 0, nearest = nearest_side(away);
    bool is_told = false;
    for (int side = 0; side < 4; ++side) {
        if (away[side] < at_corner_px) ++near;
        else if (side != nearest) continue;
        is_told = is_told || lines_of[side].x >> 7 == edge || lines_of[side].y >> 7 == edge;
    }
    return bvec2(is_told, near > 1);
}

uint face_at(ivec2 p) { return texelFetch(codes, p, 0).r & 0x7fffffu; }
bool is_nothing(ivec2 p) { return texelFetch(codes, p, 0).r == 0u; }

/// Whether what is seen at a sample is on the patch of a face, or beside it.
bool is_own(ivec2 sample_at, uint face) {
    if (is_nothing(sample_at)) return false;
    uint patch_seen = corners_of(face_at(sample_at)).w;
    uvec4 twins = rest_of(face);
    bool is_found = corners_of(face).w == patch_seen;
    for (int i = 0; i < 3 && !is_found; ++i)
        is_found = twins[i] < 0xfffffffbu && corners_of((twins[i] & 0x3ffffffcu) >> 2).w == patch_seen;
    return is_found;
}

/// Whether a line that leaves the cell over a side where no sample has it is seen there.
bool is_seen(ivec2 p, vec2 place, float q, uint face) {
    int side = nearest_side(away_from_sides(place));
    ivec2 first = p + first_of(side), second = first + along_of(side);
    float s = clamp((side & 1) == 0 ? place.x : place.y, 0.0, 1.0);
    uvec2 lines = lines_of[side];
    float q_seen;
    bool has_lines = lines.x != 0u;
    if (has_lines) {
        float low = float(lines.x & 127u) / 127.0, high = lines.y == 0u ? low : float(lines.y & 127u) / 127.0;
        if (s > min(low, high) && s < max(low, high)) return true;
        ivec2 nearer = s <= min(low, high) ? first : second;
        if (is_nothing(nearer)) return true;
        q_seen = dot(plane_of(face_at(nearer), p), vec3(place, 1));
    } else {
        q_seen = mix(uintBitsToFloat(texelFetch(depths, first, 0).r), uintBitsToFloat(texelFetch(depths, second, 0).r), s);
        if (q_seen == 0.0) return true;
    }
    if (has_lines || (is_own(first, face) && is_own(second, face))) return q_seen <= q * (1.0 + 2e-5);
    float least = 0.2 / (size.x * projectionMatrix[0][0]) * (projectionMatrix[3][3] == 0.0 ? q : 1.0);
    return q_seen <= q - least;
}
//-- end
layout(location = 0) out highp uvec4 drawn;  // as those of chords
layout(location = 1) out highp uvec4 exits;  // lines that go on unseen by samples: edge << 4 | class << 1 | to its first point

//-- kinds of chords
const uint contour = 1u, boundary = 2u, crease = 3u, intersection = 4u, seam = 5u, no_edge = 0xffffff80u;
const float overshoot = 0.05;
const int most_lines = 4;

/// The same edge as its other face has it; itself at a border or of many faces.
uint twin_of(uint edge) {
    uint twin = rest_of(edge >> 2)[edge & 3u];
    return twin >= 0xfffffffbu ? edge : (twin & 0x3ffffffcu) | (twin & 3u);
}

float facing_of(uint face, ivec2 p) {
    uvec4 corners = corners_of(face);
    return sign(determinant(mat3(seen(corners.x, p).xyw, seen(corners.y, p).xyw, seen(corners.z, p).xyw)));
}

/// The class of an edge that creases, or ends what is seen of a surface; 0 of others.
uint kind_of(uint edge, ivec2 p) {
    uvec4 rest = rest_of(edge >> 2);
    uint twin = rest[edge & 3u], kind = rest.w >> (3u * (edge & 3u)) & 7u;
    if (twin >= 0xfffffffbu) return twin == 0xffffffffu ? boundary : crease;
    float turned = (twin & 0x80000000u) != 0u ? -1.0 : 1.0;
    return facing_of(edge >> 2, p) * facing_of((twin & 0x3ffffffcu) >> 2, p) == turned ? kind : contour;
}

/// The one other line at an end of an edge; the edge itself if there are more, or none.
uint other_at(uint edge, uint point, ivec2 p) {
    uint found = edge;
    for (int way = 0; way < 2; ++way) {
        uint around = way == 0 ? edge : twin_of(edge);
        if (way == 1 && around == edge) break;
        for (int step = 0; step < 12; ++step) {
            uvec4 corners = corners_of(around >> 2);
            uint beside = (around & 3u) + (corners[around & 3u] == point ? 2u : 1u);
            uint next = (around & ~3u) | beside % 3u;
            around = twin_of(next);
            if (kind_of(next, p) == 0u) continue;
            next = min(next, around);
            if (way == 1 && found != next) return edge;
            found = next;
            break;
        }
    }
    return found;
}

/// A line of a cell: of an edge and a face, or where two faces meet.
struct Line { uint edge, face, kind; uvec2 points; };

ivec2 p;  // the cell
Line line[most_lines];
vec2 ends[2 * most_lines], qs[most_lines];  // two ends each, and 1/distance there
bool dangles[2 * most_lines];
vec2 unknown[most_lines];  // where what is not known to be of an edge crosses a side
int count = 0, unknown_count = 0;

void draw(vec2 from, vec2 to, uint kind) {
    uvec4 ends = uvec4(255.0 * clamp(vec4(from, to), 0.0, 1.0) + 0.5);
    uint piece = of_kind(ends.x << 24 | ends.y << 16 | ends.z << 8 | ends.w, kind);
    drawn = uvec4(max(piece, 1u), drawn.xyz);  // 0 would end the list
}

/// The line goes on out of the cell, towards the first or the second point of its edge.
void leave(uint edge, uint kind, bool is_to_first) { exits = uvec4(edge << 4 | kind << 1 | uint(is_to_first), exits.xyz); }

/// Of an edge that crosses a side the class: a border is a seam where another object goes on as far.
uint kind_at(uint edge, ivec2 first, ivec2 second, vec2 crossed) {
    if (!has_classes) return 0u;
    uint kind = kind_of(edge, p);
    if (kind != boundary || is_nothing(first) || is_nothing(second)) return kind;
    uint a = face_at(first), b = face_at(second);
    float q_a = dot(plane_of(a, p), vec3(crossed, 1)), q_b = dot(plane_of(b, p), vec3(crossed, 1));
    bool are_two = ((rest_of(a).w ^ rest_of(b).w) >> 9 & 0x3fffu) != 0u;
    return are_two && abs(q_a - q_b) <= 1e-4 * q_a ? seam : boundary;
}

/// Takes what crosses a side: all of its edge that lies in the cell.
void take(uint word, int side) {
    uint edge = word >> 7, face = edge >> 2;
    for (int k = 0; k < count; ++k)
        if (line[k].edge == edge) return;
    ivec2 first = p + first_of(side), second = first + along_of(side);
    vec2 crossed = vec2(first_of(side)) + float(word & 127u) / 127.0 * vec2(along_of(side));
    bool is_edge = edge != no_edge >> 7, is_plain = false;
    uvec2 of_edge = uvec2(0);
    vec4 a = vec4(0), b = vec4(0);
    if (count < most_lines && is_edge) {
        of_edge = points_of(edge);
        a = seen(of_edge.x, p), b = seen(of_edge.y, p);
        is_plain = a.w > 0.0 && b.w > 0.0;
    } else if (count < most_lines && !is_nothing(first) && !is_nothing(second)) {  // where both surfaces are as far
        face = face_at(first);
        vec3 plane = plane_of(face, p), apart = plane - plane_of(face_at(second), p);
        float before = dot(apart, vec3(first - p, 1)), after = dot(apart, vec3(second - p, 1));
        vec2 to = vec2(-apart.y, apart.x) / max(length(apart.xy), 1e-30);
        is_plain = before * after < 0.0;
        crossed = is_plain ? vec2(first - p) + before / (before - after) * vec2(second - first) : crossed;
        a = vec4(crossed - 2.0 * to, 0, 1), b = vec4(crossed + 2.0 * to, 0, 1);
        a.z = dot(plane, a.xyw), b.z = dot(plane, b.xyw);
    }
    if (is_plain) {
        a /= a.w, b /= b.w;
        vec2 part = clipped(a.xy, b.xy);
        is_plain = part.x < part.y;
        if (is_plain) {
            line[count] = Line(edge, face, is_edge ? kind_at(edge, first, second, crossed) : intersection, of_edge);
            ends[2 * count] = mix(a.xy, b.xy, part.x), ends[2 * count + 1] = mix(a.xy, b.xy, part.y);
            qs[count] = mix(a.zz, b.zz, part);
            dangles[2 * count] = part.x == 0.0, dangles[2 * count + 1] = part.y == 1.0;
            ++count;
        }
    }
    if (!is_plain && unknown_count < most_lines) unknown[unknown_count++] = crossed;
}

/// Of an end that leaves the cell decides what samples do not tell: the line goes on, or is hidden by a line before.
void settle(int i) {
    Line of = line[i / 2];
    if (dangles[i] || any(is_known(ends[i], of.edge))) return;
    if (is_seen(p, ends[i], qs[i / 2][i & 1], of.face)) {
        if (of.edge != no_edge >> 7) leave(of.edge, of.kind, (i & 1) == 0);
        return;
    }
    vec2 from = ends[i ^ 1], way = ends[i] - from;
    float nearest = 2.0;
    for (int k = 0; k < count; ++k) {
        if (k == i / 2) continue;
        vec2 begin = ends[2 * k] - from, other = ends[2 * k + 1] - ends[2 * k];
        float turn = determinant(mat2(way, other));
        if (abs(turn) < 1e-9) continue;
        float t = determinant(mat2(begin, other)) / turn, u = determinant(mat2(begin, way)) / turn;
        if (t < 0.0 || t > 1.0 || u < -overshoot || u > 1.0 + overshoot) continue;
        float q = mix(qs[i / 2][1 - (i & 1)], qs[i / 2][i & 1], t);
        if (mix(qs[k].x, qs[k].y, u) >= q * (1.0 - 1e-4)) nearest = min(nearest, t);
    }
    if (nearest <= 1.0) ends[i] = from + nearest * way;
}

/// Lets two ends at one place be one.
bool meets(int i, vec2 place) {
    for (int k = 0; k < 2 * count; ++k)
        if (dangles[i] && dangles[k] && k / 2 != i / 2 && distance(ends[k], place) < at_corner_px) dangles[i] = dangles[k] = false;
    return !dangles[i];
}

/// From an end at a vertex on over vertices, to another end or out of the cell.
void follow(int i) {
    uint edge = line[i / 2].edge, point = line[i / 2].points[i & 1];
    for (int step = 0; step < 4 && dangles[i]; ++step) {
        uint next = other_at(edge, point, p);
        if (next == edge) break;
        uvec2 of_edge = points_of(next);
        bool is_to_first = of_edge.y == point;
        edge = next;
        vec4 a = seen(point, p), b = seen(is_to_first ? of_edge.x : of_edge.y, p);
        point = is_to_first ? of_edge.x : of_edge.y;
        if (b.w <= 0.0) break;
        a /= a.w, b /= b.w;
        float t = clipped(a.xy, b.xy).y;
        vec3 end = mix(a.xyz, b.xyz, t);
        uint kind = has_classes ? kind_of(edge, p) : 0u;
        if (t < 1.0) {
            if (!any(is_known(end.xy, edge))) {
                if (!is_seen(p, end.xy, end.z, edge >> 2)) break;
                leave(edge, kind, is_to_first);
            }
            dangles[i] = false;
        }
        if (meets(i, end.xy)) draw(ends[i], end.xy, kind);
    }
}

/// Joins an end that is left to the nearest such of another line.
void join(int i) {
    int best = -1;
    for (int k = i + 1; k < 2 * count; ++k)
        if (dangles[k] && k / 2 != i / 2 && (best < 0 || distance(ends[k], ends[i]) < distance(ends[best], ends[i]))) best = k;
    if (best < 0) return;
    dangles[best] = dangles[i] = false;
    draw(ends[i], ends[best], line[i / 2].kind);
}

/// Joins what crosses a side to the nearest end, or to another such, or halfway across.
void join_unknown(int i) {
    vec2 from = unknown[i], way = abs(from - 0.5), best = vec2(9);
    for (int k = 0; k < 2 * count; ++k)
        if (dangles[k] && distance(ends[k], from) < distance(best, from)) best = ends[k];
    if (best.x > 8.0)
        for (int k = 0; k < unknown_count; ++k)
            if (k != i && distance(unknown[k], from) < distance(best, from)) best = unknown[k];
    if (best.x > 8.0) best = way.x > way.y ? vec2(0.5, from.y) : vec2(from.x, 0.5);
    draw(from, best, contour);
}

void main() {
    p = ivec2(gl_FragCoord.xy);
    drawn = uvec4(0), exits = uvec4(0);
    read_sides(p);
    for (int i = 0; i < 8; ++i) {
        uint word = lines_of[i / 2][i & 1];
        if (word != 0u) take(word, i / 2);
    }
    for (int i = 0; i < 2 * count; ++i) settle(i);
    for (int i = 0; i < count; ++i) draw(ends[2 * i], ends[2 * i + 1], line[i].kind);
    for (int i = 0; i < 2 * count; ++i) meets(i, ends[i]);
    for (int i = 0; i < 2 * count; ++i) if (dangles[i]) follow(i);
    for (int i = 0; i < 2 * count; ++i) if (dangles[i]) join(i);
    for (int i = 0; i < unknown_count; ++i) join_unknown(i);
}
//// ways
//-- edges of strokes
uniform highp usampler2D exits;
out highp uvec4 drawn;  // from and to, px, as bits of floats; the last three of the first are the class

const ivec2 block = ivec2(8, 4);  // px, whose longest ways are four texels

/// On along an edge from a cell, as far as nothing hides it, to where samples have it again.
vec4 way_of(uint leaves, ivec2 cell) {
    uint edge = leaves >> 4;
    uvec2 of_edge = points_of(edge);
    if ((leaves & 1u) != 0u) of_edge = of_edge.yx;
    vec4 a = seen(of_edge.x, cell), b = seen(of_edge.y, cell);
    a /= a.w, b /= b.w;
    float t = clipped(a.xy, b.xy).y, beyond = 1e-3 / distance(a.xy, b.xy);
    vec2 from = mix(a.xy, b.xy, t);
    for (int step = 0; step < 64; ++step) {
        vec2 way = floor(mix(a.xy, b.xy, t + beyond));  // from the first cell
        ivec2 p = cell + ivec2(way);
        float to = clipped(a.xy - way, b.xy - way).y;
        if (to <= t || min(p.x, p.y) < 0 || any(greaterThanEqual(p, ivec2(size)))) break;
        vec3 end = mix(a.xyz, b.xyz, to) - vec3(way, 0);
        read_sides(p);
        bool is_end = to == 1.0 || is_known(end.xy, edge).x, is_hidden = !is_end && !is_seen(p, end.xy, end.z, edge >> 2);
        t = is_hidden ? mix(t, to, 0.5) : to;
        if (is_end || is_hidden) break;
    }
    return vec4(from, mix(a.xy, b.xy, t)) + vec4(cell, cell);
}

/// Of a block the longest ways, of two edges each to the right and to the left.
void main() {
    ivec2 place = ivec2(gl_FragCoord.xy), first = block * ivec2(place.x / 4, place.y);
    bool is_right = (place.x & 1) == 0;
    vec2 longest = vec2(0);
    uint edge = 0u;
    vec4 ways[2] = vec4[2](vec4(0), vec4(0));
    uvec2 kinds = uvec2(0);
    for (int i = 0; i < block.x * block.y; ++i) {
        ivec2 cell = first + ivec2(i % block.x, i / block.x);
        for (uvec4 rest = texelFetch(exits, min(cell, ivec2(size) - 1), 0); rest.x != 0u; rest = uvec4(rest.yzw, 0)) {
            vec4 found = way_of(rest.x, cell);
            float length_px = distance(found.xy, found.zw);
            if ((found.z + 0.01 * found.w > found.x + 0.01 * found.y) != is_right || length_px <= longest.y) continue;
            bool is_longest = length_px > longest.x, is_other = rest.x >> 4 != edge;
            if (is_longest && is_other) longest.y = longest.x, ways[1] = ways[0], kinds.y = kinds.x;
            if (is_longest) longest.x = length_px, ways[0] = found, kinds.x = rest.x >> 1 & 7u, edge = rest.x >> 4;
            else if (is_other) longest.y = length_px, ways[1] = found, kinds.y = rest.x >> 1 & 7u;
        }
    }
    bool is_first = (place.x & 2) == 0;
    drawn = floatBitsToUint(is_first ? ways[0] : ways[1]);
    drawn.x = drawn.x & ~7u | (is_first ? kinds.x : kinds.y);
}
//// spread
precision highp float;
precision highp int;
uniform highp usampler2D ways;
uniform vec2 size, target_size;  // of the frame, and of what is drawn into
uniform float widthPx;
flat out highp vec4 way;
flat out highp uint kind;

/// A triangle that covers what a pen touches along a way.
void main() {
    int i = gl_VertexID / 3, corner = gl_VertexID - 3 * i, columns = textureSize(ways, 0).x;
    uvec4 found = texelFetch(ways, ivec2(i % columns, i / columns), 0);
    way = uintBitsToFloat(found), kind = found.x & 7u;
    vec2 along = way.zw - way.xy, reach = vec2(0.5 * widthPx + 1.5);
    float length_px = length(along);
    along /= max(length_px, 1e-6);
    vec2 at = corner == 0 ? -reach : corner == 1 ? vec2(2.0 * length_px + 3.0 * reach.x, -reach.y) : vec2(-reach.x, 3.0 * reach.y);
    vec2 place = way.xy + at.x * along + at.y * vec2(-along.y, along.x) - 0.5 * (size - target_size);
    bool is_drawn = found != uvec4(0) && length_px > 0.0;
    gl_Position = vec4(is_drawn ? 2.0 * place / target_size - 1.0 : vec2(2), 0, 1);
}
//// thin
const bool has_classes = false;
//-- pen of chords
flat in highp vec4 way;
flat in highp uint kind;
out vec4 drawn;  // the ink in the quarters of a pixel; with classes in 31 steps, each times 8 and the class

void main() {
    vec2 p = floor(gl_FragCoord.xy);
    drawn = shares_of(pen_of(way.xy - p, way.zw - p));
    if (has_classes) drawn = (8.0 * floor(31.0 * drawn + 0.5) + float(kind) * vec4(greaterThan(drawn, vec4(0)))) / 255.0;
}
//// lines
const bool keeps_half = false, has_thin = true;
//-- pen of chords
//-- ink of chords
