// strokes in GLSL ES 3.00 (WebGL 2): as chords, but a piece of a line is its edge, clipped to the cell.
//
// As chords is drawn, but `sides` into RGBA32UI, and `cells` reads codes, depths and the tables, too.
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
precision highp float;
precision highp int;
uniform highp usampler2D sides, codes, depths, faces;
uniform highp sampler2D points;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec2 size;
out highp uvec4 drawn;  // as those of chords

const float at_corner_px = 0.02, overshoot = 0.05;
const int most_lines = 4;

ivec2 at(int i) { return ivec2(i & 4095, i >> 12); }

/// Of a point: x and y in the cell p times w, 1/distance times w, and w.
vec4 seen(uint point, ivec2 p) {
    vec4 clip = projectionMatrix * (modelViewMatrix * texelFetch(points, at(int(point)), 0));
    float z = projectionMatrix[2][2] < 0.0 ? 1.0 - clip.z : clip.z;
    float q = projectionMatrix[3][3] == 0.0 ? 1.0 : z / abs(projectionMatrix[2][2]);
    return vec4(0.5 * (clip.xy * size + clip.w * size) - clip.w * vec2(p), q, clip.w);
}

/// A face's plane: 1/distance of it by x, by y and at the first corner of the cell p.
vec3 plane_of(uint face, ivec2 p) {
    uvec4 corners = texelFetch(faces, at(2 * int(face)), 0);
    vec4 a = seen(corners.x, p), b = seen(corners.y, p), c = seen(corners.z, p);
    return vec3(a.z, b.z, c.z) * inverse(mat3(a.xyw, b.xyw, c.xyw));
}

/// The four sides of a cell: above is none, as rows go up: below, right, above, left.
ivec2 first_of(int side) { return ivec2(side == 1, side == 2); }
ivec2 way_of(int side) { return (side & 1) == 0 ? ivec2(1, 0) : ivec2(0, 1); }
int nearest_side(vec2 place) {
    vec4 away = abs(vec4(place.y, place.x - 1.0, place.y - 1.0, place.x));
    float least = min(min(away.x, away.y), min(away.z, away.w));
    return away.x == least ? 0 : away.y == least ? 1 : away.z == least ? 2 : 3;
}

uvec2 lines_of[4];  // by sides
uint face_at(ivec2 p) { return texelFetch(codes, p, 0).r & 0x7fffffu; }
bool is_nothing(ivec2 p) { return texelFetch(codes, p, 0).r == 0u; }

/// Whether one of two faces is on the patch of the other, or beside it.
bool is_own(ivec2 sample_at, uint face) {
    if (is_nothing(sample_at)) return false;
    uint patch_seen = texelFetch(faces, at(2 * int(face_at(sample_at))), 0).w;
    uvec4 twins = texelFetch(faces, at(2 * int(face) + 1), 0);
    if (texelFetch(faces, at(2 * int(face)), 0).w == patch_seen) return true;
    for (int i = 0; i < 3; ++i) {
        if (twins[i] >= 0xfffffffbu) continue;
        if (texelFetch(faces, at(2 * int((twins[i] & 0x3ffffffcu) >> 2)), 0).w == patch_seen) return true;
    }
    return false;
}

/// Whether a line that leaves the cell over a side where no sample has it is seen there.
bool is_seen(ivec2 p, vec2 place, float q, uint face) {
    int side = nearest_side(place);
    ivec2 first = p + first_of(side), second = first + way_of(side);
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

/// The same edge as its other face has it; itself at a border or of many faces.
uint twin_of(uint edge) {
    uint twin = texelFetch(faces, at(2 * int(edge >> 2) + 1), 0)[edge & 3u];
    return twin >= 0xfffffffbu ? edge : (twin & 0x3ffffffcu) | (twin & 3u);
}

float facing_of(uint face, ivec2 p) {
    uvec4 corners = texelFetch(faces, at(2 * int(face)), 0);
    return sign(determinant(mat3(seen(corners.x, p).xyw, seen(corners.y, p).xyw, seen(corners.z, p).xyw)));
}

/// Whether an edge creases, or ends what is seen of a surface.
bool is_line(uint edge, ivec2 p) {
    uvec4 rest = texelFetch(faces, at(2 * int(edge >> 2) + 1), 0);
    uint twin = rest[edge & 3u];
    if (twin >= 0xfffffffbu || (rest.w >> (3u * (edge & 3u)) & 7u) != 0u) return true;
    return facing_of(edge >> 2, p) * facing_of((twin & 0x3ffffffcu) >> 2, p) != ((twin & 0x80000000u) != 0u ? -1.0 : 1.0);
}

/// The one other line at an end of an edge; the edge itself if there are more, or none.
uint other_at(uint edge, uint point, ivec2 p) {
    uint found = edge;
    for (int way = 0; way < 2; ++way) {
        uint around = way == 0 ? edge : twin_of(edge);
        if (way == 1 && around == edge) break;
        for (int step = 0; step < 12; ++step) {
            uvec4 corners = texelFetch(faces, at(2 * int(around >> 2)), 0);
            uint beside = (around & 3u) + (corners[around & 3u] == point ? 2u : 1u);
            uint next = (around & ~3u) | beside % 3u;
            around = twin_of(next);
            if (!is_line(next, p)) continue;
            next = min(next, around);
            if (way == 1 && found != next) return edge;
            found = next;
            break;
        }
    }
    return found;
}

/// A line of a cell: of an edge and a face, or where two faces meet.
struct Line { uint edge, face; uvec2 points; };

uint piece_of(vec2 from, vec2 to) {
    uvec4 ends = uvec4(255.0 * clamp(vec4(from, to), 0.0, 1.0) + 0.5);
    return max(ends.x << 24 | ends.y << 16 | ends.z << 8 | ends.w, 1u);  // 0 would end the list
}

float across(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    drawn = uvec4(0);
    uvec4 own = texelFetch(sides, p, 0);
    lines_of = uvec2[4](own.xy, texelFetch(sides, p + ivec2(1, 0), 0).zw, texelFetch(sides, p + ivec2(0, 1), 0).xy, own.zw);
    uint words[8] = uint[8](lines_of[0].x, lines_of[0].y, lines_of[1].x, lines_of[1].y,
                            lines_of[2].x, lines_of[2].y, lines_of[3].x, lines_of[3].y);
    vec2 ends[8];    // of lines, two each
    vec2 qs[4];      // at these
    bool dangles[8];
    Line line[4];
    vec2 unknown[4];
    int count = 0, unknown_count = 0;
    for (int i = 0; i < 8; ++i) {
        if (words[i] == 0u) continue;
        float s = float(words[i] & 127u) / 127.0;
        int side = i / 2;
        vec2 crossed = vec2(first_of(side)) + s * vec2(way_of(side));
        uint edge = words[i] >> 7;
        bool is_known = false;
        for (int k = 0; k < count; ++k) is_known = is_known || line[k].edge == edge;
        if (is_known) continue;
        vec2 part = vec2(0, 1);
        vec4 a = vec4(0), b = vec4(0);
        bool is_plain = false;
        uint face = edge >> 2;
        uvec2 of_edge = uvec2(0);
        if (edge == 0xffffff80u >> 7) {
            ivec2 first = p + first_of(side), second = first + way_of(side);
            if (count < most_lines && !is_nothing(first) && !is_nothing(second)) {  // where both surfaces are as far
                face = face_at(first);
                vec3 plane = plane_of(face, p), apart = plane - plane_of(face_at(second), p);
                float before = dot(apart, vec3(first - p, 1)), after = dot(apart, vec3(second - p, 1));
                vec2 to = vec2(-apart.y, apart.x) / max(length(apart.xy), 1e-30);
                is_plain = before * after < 0.0;
                crossed = is_plain ? vec2(first - p) + before / (before - after) * vec2(second - first) : crossed;
                a = vec4(crossed - 2.0 * to, 0, 1), b = vec4(crossed + 2.0 * to, 0, 1);
                a.z = dot(plane, a.xyw), b.z = dot(plane, b.xyw);
            }
        } else if (count < most_lines) {
            uvec4 corners = texelFetch(faces, at(2 * int(face)), 0);
            of_edge = uvec2(corners[edge & 3u], corners[((edge & 3u) + 1u) % 3u]);
            a = seen(of_edge.x, p), b = seen(of_edge.y, p);
            is_plain = a.w > 0.0 && b.w > 0.0;
        }
        if (is_plain) {
            a /= a.w, b /= b.w;
            vec2 way = b.xy - a.xy;
            for (int axis = 0; axis < 2; ++axis) {
                if (abs(way[axis]) < 1e-6) continue;
                vec2 t = (vec2(0, 1) - a[axis]) / way[axis];
                part = vec2(max(part.x, min(t.x, t.y)), min(part.y, max(t.x, t.y)));
            }
            is_plain = part.x < part.y;
        }
        if (!is_plain) {
            if (unknown_count < 4) unknown[unknown_count++] = crossed;
            continue;
        }
        line[count] = Line(edge, face, of_edge);
        ends[2 * count] = mix(a.xy, b.xy, part.x), ends[2 * count + 1] = mix(a.xy, b.xy, part.y);
        qs[count] = vec2(mix(a.z, b.z, part.x), mix(a.z, b.z, part.y));
        dangles[2 * count] = part.x == 0.0, dangles[2 * count + 1] = part.y == 1.0;
        ++count;
    }
    for (int i = 0; i < 2 * count; ++i) {  // ends that no sample tells of
        if (dangles[i]) continue;
        vec4 away = abs(vec4(ends[i].y, ends[i].x - 1.0, ends[i].y - 1.0, ends[i].x));
        bool is_sure = false;
        int near = 0;
        for (int side = 0; side < 4; ++side) {
            if (away[side] < at_corner_px) ++near;
            if (away[side] >= at_corner_px && side != nearest_side(ends[i])) continue;
            is_sure = is_sure || lines_of[side].x >> 7 == line[i / 2].edge || lines_of[side].y >> 7 == line[i / 2].edge;
        }
        if (is_sure || near > 1 || is_seen(p, ends[i], qs[i / 2][i & 1], line[i / 2].face)) continue;
        vec2 from = ends[i ^ 1], way = ends[i] - from;
        float nearest = 2.0;
        for (int k = 0; k < count; ++k) {
            if (k == i / 2) continue;
            vec2 begin = ends[2 * k] - from, other = ends[2 * k + 1] - ends[2 * k];
            float turn = across(way, other);
            if (abs(turn) < 1e-9) continue;
            float t = across(begin, other) / turn, u = across(begin, way) / turn;
            if (t < 0.0 || t > 1.0 || u < -overshoot || u > 1.0 + overshoot) continue;
            float q = mix(qs[i / 2][1 - (i & 1)], qs[i / 2][i & 1], t);
            if (mix(qs[k].x, qs[k].y, u) >= q * (1.0 - 1e-4)) nearest = min(nearest, t);
        }
        if (nearest <= 1.0) ends[i] = from + nearest * way;
    }
    for (int i = 0; i < count; ++i) drawn = uvec4(piece_of(ends[2 * i], ends[2 * i + 1]), drawn.xyz);
    for (int i = 0; i < 2 * count; ++i)  // ends at one vertex
        for (int k = 0; k < i; ++k)
            if (dangles[i] && dangles[k] && i / 2 != k / 2 && distance(ends[i], ends[k]) < at_corner_px) dangles[i] = dangles[k] = false;
    for (int i = 0; i < 2 * count; ++i) {  // on over vertices, to another end or out of the cell
        uint edge = line[i / 2].edge, point = line[i / 2].points[i & 1];
        for (int step = 0; step < 4 && dangles[i]; ++step) {
            uint next = other_at(edge, point, p);
            if (next == edge) break;
            uvec4 corners = texelFetch(faces, at(2 * int(next >> 2)), 0);
            uvec2 of_edge = uvec2(corners[next & 3u], corners[((next & 3u) + 1u) % 3u]);
            vec4 a = seen(point, p), b = seen(of_edge.x == point ? of_edge.y : of_edge.x, p);
            if (b.w <= 0.0) break;
            edge = next, point = of_edge.x == point ? of_edge.y : of_edge.x;
            a /= a.w, b /= b.w;
            vec2 far = (vec2(greaterThan(b.xy, a.xy)) - a.xy) / (b.xy - a.xy);
            float t = min(min(far.x, far.y), 1.0);
            vec3 end = mix(a.xyz, b.xyz, t);
            if (t < 1.0) {
                if (!is_seen(p, end.xy, end.z, edge >> 2)) break;
                dangles[i] = false;
            }
            for (int k = 0; k < 2 * count; ++k)
                if (dangles[i] && dangles[k] && k / 2 != i / 2 && distance(ends[k], end.xy) < at_corner_px) dangles[i] = dangles[k] = false;
            if (!dangles[i]) drawn = uvec4(piece_of(ends[i], end.xy), drawn.xyz);
        }
    }
    for (int i = 0; i < 2 * count; ++i) {  // others, two by two
        if (!dangles[i]) continue;
        int best = -1;
        for (int k = i + 1; k < 2 * count; ++k)
            if (dangles[k] && k / 2 != i / 2 && (best < 0 || distance(ends[k], ends[i]) < distance(ends[best], ends[i]))) best = k;
        if (best < 0) continue;
        dangles[best] = dangles[i] = false;
        drawn = uvec4(piece_of(ends[i], ends[best]), drawn.xyz);
    }
    for (int i = 0; i < unknown_count; ++i) {
        vec2 best = vec2(9);
        for (int k = 0; k < 2 * count; ++k)
            if (dangles[k] && distance(ends[k], unknown[i]) < distance(best, unknown[i])) best = ends[k];
        if (best.x > 8.0)
            for (int k = 0; k < unknown_count; ++k)
                if (k != i && distance(unknown[k], unknown[i]) < distance(best, unknown[i])) best = unknown[k];
        vec2 way = abs(unknown[i] - 0.5);  // or halfway across
        if (best.x > 8.0) best = way.x > way.y ? vec2(0.5, unknown[i].y) : vec2(unknown[i].x, 0.5);
        drawn = uvec4(piece_of(unknown[i], best), drawn.xyz);
    }
}
//// lines
const bool keeps_half = false;
//-- ink of chords
