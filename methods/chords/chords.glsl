// chords in GLSL ES 3.00 (WebGL 2): ink of lines 1 to 4 px wide, from a sample at each corner of a pixel.
//
// All but the last pass draw more than the image, by ceil(widthPx / 2) px on each side; `size` and `projectionMatrix`
// are of that larger frame. `vertex` and `fragment` draw the mesh and `marks` marks as those of surface_lookup. Then `tiles`
// draws points: with `sides` into RGBA16UI of one column and row more than the frame, with `cells` into RGBA32UI of
// the frame, both cleared to 0, and as `screen` does with `lines` over the image. Names are those of three.js.
//// vertex of surface_lookup
//// fragment of surface_lookup
//// screen of surface8
//// tiles of surface_lookup
//// marks
//-- judging of surface_lookup
out highp uint drawn;

void main() {
    ivec2 told = told_at(ivec2(gl_FragCoord.xy));
    drawn = told == ivec2(no_line) ? 0u : 4u;
}
//// sides
const bool notes_lines = true;  // and walks end where the surface does
//-- judging of surface_lookup
//-- walks of surface_lookup
//-- between
out highp uvec4 drawn;  // as line_word, class << 16: two lines of the side to the next column, two of that to the next row

const uint unknown = no_edge | (most_place + 1u) / 2u;  // a line in the middle

/// Adds those between two places; two are kept.
void add(inout uvec2 kept, uvec4 lines, int after, int before) {
    for (int i = 0; i < 4; ++i) {
        int place = int(lines[i] & most_place);
        if (lines[i] == 0u || place <= after || place >= before) continue;
        kept = kept.x == 0u ? uvec2(lines[i], 0) : kept.y == 0u ? uvec2(kept.x, lines[i]) : kept;
    }
}

/// Lines of a walk from its sample on, and as the other sample has them.
uvec4 in_order(uvec4 lines) { return lines.wzyx; }
uvec4 seen_back(uvec4 lines) { return (lines ^ most_place) * uvec4(notEqual(lines, uvec4(0))); }

/// Where surfaces meet of which neither ends before the other.
uint meeting_of(Walk there, Walk back, float q_first, float q_second) {
    if (there.end == cut || back.end == cut) return 0u;
    if (there.end != beyond || back.end != beyond) return of_class(unknown, intersection);
    float before = q_first - q_on(back, 1.0), after = q_on(there, 1.0) - q_second;
    if (max(abs(before), abs(after)) <= 1e-6 * q_first) return 0u;
    return of_class(no_edge | place_of(before != after ? before / (before - after) : 0.5), intersection);
}

/// The first two lines between two samples.
uvec2 lines_between(ivec2 p, ivec2 to) {
    uint a = word_at(p), b = word_at(p + to);
    uvec2 kept = uvec2(0);
    bool is_sky = a == 0u || b == 0u;
    uint face_a = a & 0x7fffffu, face_b = b & 0x7fffffu;
    Walk there = Walk(lost, vec2(0), 0u, vec2(0), 0u, uvec4(0), -1.0), back = there;
    for (int i = 0; i < 3; ++i) {  // there, back, and there again where the other line hides this surface
        bool is_back = i == 1;
        if ((is_back ? b : a) == 0u) continue;
        if (i == 2 && (!is_at_line(back) || (is_at_line(there) && there.left.x <= 1.0 - back.left.x))) break;
        Walk walked = walk(is_back ? p + to : p, is_back ? -to : to, is_back ? face_b : face_a,
                           is_sky ? nothing : is_back ? face_a : face_b, is_back ? 1.0 - there.left.x : 1.0 - back.left.x);
        if (is_back) back = walked;
        else if (i == 0) there = walked;
        else there.q_asked = walked.q_asked;
        if (walked.end == arrived) {
            add(kept, is_back ? seen_back(back.lines) : in_order(there.lines), -1, 256);
            return kept;
        }
    }
    if (has_classes && there.end == fork && back.end == fork)
        there.lines.x = of_class(there.lines.x, crease), back.lines.x = of_class(back.lines.x, crease);
    uvec4 first = in_order(there.lines), second = seen_back(back.lines);
    bool has_first = is_at_line(there), has_second = is_at_line(back);
    if (is_sky) {
        int end = min(there.end, back.end);  // sky is lost
        if (end == beyond || end == cut) return kept;
        if (!has_first && !has_second) return uvec2(of_class(unknown, contour), 0);
        add(kept, a == 0u ? second : first, -1, 256);
        return kept;
    }
    if (is_lost(there, back) && patch_of(face_a) == patch_of(face_b)) return kept;
    bool goes_there = goes_on(there, q_at(p + to)), goes_back = goes_on(back, q_at(p));
    if (goes_there || goes_back) {
        bool is_seam = goes_there != goes_back && (goes_there ? has_second : has_first);
        if (is_seam && object_of(face_a) != object_of(face_b)) kept.x = of_class(goes_there ? second.x : there.lines.x, seam);
        return kept;
    }
    if (is_crack(there, back)) {
        if (object_of(face_a) != object_of(face_b)) kept.x = of_class(there.lines.x, seam);
        return kept;
    }
    bool is_gap = has_first && has_second && there.left.x <= 1.0 - back.left.x + 1e-4;
    bool is_first = has_first && there.left.y >= back.q_asked * (1.0 - 1e-6);
    bool is_second = has_second && back.left.y >= there.q_asked * (1.0 - 1e-6);
    if (is_first && is_second) is_first = there.left.y >= back.left.y, is_second = !is_first;
    if (is_gap) is_first = is_second = true;
    uint meeting = is_first || is_second ? 0u : meeting_of(there, back, q_at(p), q_at(p + to));
    if (!is_first && !is_second && meeting == 0u) return kept;
    int at_meeting = int(meeting & most_place);
    add(kept, first, -1, is_first ? 256 : is_second ? int(place_of(1.0 - back.left.x)) : at_meeting + 1);
    add(kept, uvec4(meeting, 0, 0, 0), -1, 256);
    add(kept, second, is_second ? -1 : is_first ? int(place_of(there.left.x)) : at_meeting - 1, 256);
    return kept;
}

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy), told = told_at(p);
    drawn = uvec4(0);
    // A loop over those that may have lines, or each walk stands here six times.
    for (uint todo = uint(told.x != no_line) | uint(told.y != no_line) << 1; todo != 0u; todo &= todo - 1u) {
        bool is_across = (todo & 1u) != 0u;
        uvec2 kept = lines_between(p, is_across ? ivec2(1, 0) : ivec2(0, 1));
        drawn = is_across ? uvec4(kept, 0, 0) : uvec4(drawn.xy, kept);
    }
}
//-- end
//// cells
precision highp float;
precision highp int;
const bool has_classes = false;
uniform highp usampler2D sides;
out highp uvec4 drawn;  // four pieces: from << 16 | to, an end as x << 8 | y in 1/255 of the cell, or with classes in 2/255

//-- kinds
/// A piece as one of a class.
uint of_kind(uint piece, uint kind) {
    return has_classes ? piece & 0xfefefeffu | (kind & 1u) << 24 | (kind & 2u) << 15 | (kind & 4u) << 6 : piece;
}
//-- end
void join(uint a, uint b) {
    uint piece = of_kind(a << 16 | b & 0xffffu, a >> 24);
    drawn = uvec4(max(piece, 1u), drawn.xyz);  // 0 would end the list
}

/// An end: class << 24 | name << 16 | x << 8 | y.
uint end_of(uint line, int side) {
    uint place = line & 255u, far = side == 1 || side == 2 ? 255u : 0u;
    return line == 0u ? 0u : line >> 8 << 16 | ((side & 1) == 0 ? place << 8 | far : far << 8 | place);
}

uint name_of(uint end) { return has_classes ? end >> 16 & 255u : end >> 16; }
vec2 place(uint end) { return vec2(end >> 8 & 255u, end & 255u); }
uint end_at(vec2 place) {
    uvec2 nearest = uvec2(place + 0.5);
    return nearest.x << 8 | nearest.y;
}

/// Where an end goes that is left alone: to the nearest chord, which hides it, and without one halfway across.
uint end_of_lone(uint end) {
    vec2 from = place(end), way = abs(from - 127.5), best = vec2(1e4);
    if (drawn.x == 0u) return end_at(way.x > way.y ? vec2(127.5, from.y) : vec2(from.x, 127.5));
    for (uvec4 rest = drawn; rest.x != 0u; rest = uvec4(rest.yzw, 0)) {
        vec2 first = place(rest.x >> 16), along = place(rest.x) - first;
        vec2 at = first + clamp(dot(from - first, along) / max(dot(along, along), 1e-9), 0.0, 1.0) * along;
        if (distance(at, from) < distance(best, from)) best = at;
    }
    return end_at(best);
}

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    drawn = uvec4(0);
    uvec4 own = texelFetch(sides, p, 0);
    uvec2 right = texelFetch(sides, p + ivec2(1, 0), 0).zw, above = texelFetch(sides, p + ivec2(0, 1), 0).xy;
    if (all(equal(own, uvec4(0))) && all(equal(uvec4(right, above), uvec4(0)))) return;
    uint ends[8] = uint[8](end_of(own.x, 0), end_of(own.y, 0), end_of(right.x, 1), end_of(right.y, 1),
                           end_of(above.x, 2), end_of(above.y, 2), end_of(own.z, 3), end_of(own.w, 3));
    for (int i = 1; i < 8; ++i)  // ends of one edge
        for (int k = 0; k < i; ++k) {
            if (ends[i] == 0u || name_of(ends[i]) != name_of(ends[k]) || name_of(ends[i]) == 255u) continue;
            join(ends[k], ends[i]);
            ends[i] = ends[k] = 0u;
        }
    float count = 0.0;
    vec2 sum = vec2(0);
    uint last = 0u;
    for (int i = 0; i < 8; ++i) {
        if (ends[i] == 0u) continue;
        count += 1.0;
        sum += place(ends[i]);
        last = ends[i];
    }
    uint star = count == 1.0 ? end_of_lone(last) : count == 2.0 ? last : end_at(sum / max(count, 1.0));
    for (int i = 0; i < 8; ++i)
        if (ends[i] != 0u && ends[i] != star) join(ends[i], star);
}
//// lines
const bool keeps_half = true, has_thin = false;
//-- pen
precision highp float;
precision highp int;
uniform float widthPx;

/// The share of a unit square on the near side of a straight line that passes its middle, x beyond it; of the
/// line's normal the larger and the smaller part.
vec4 share_within(vec4 x, vec4 larger, vec4 smaller) {
    vec4 left = max(0.5 * (larger + smaller) - abs(x), 0.0);
    vec4 corner = left * left / max(2.0 * larger * smaller, 1e-9), trapezium = (left - 0.5 * smaller) / larger;
    vec4 less = mix(trapezium, corner, lessThan(left, smaller));
    less = mix(vec4(0), less, greaterThan(left, vec4(0)));
    return mix(less, 1.0 - less, greaterThan(x, vec4(0)));
}

/// Of the middles of a pixel's quarters: by how much a pen reaches over them, and the way to the line's middle.
struct Pen { vec4 over, way_x, way_y; };

/// Of a piece between two places in the pixel.
Pen pen_of(vec2 from, vec2 to) {
    vec2 along = to - from;
    vec4 to_x = vec4(0.25, 0.75, 0.25, 0.75) - from.x, to_y = vec4(0.25, 0.25, 0.75, 0.75) - from.y;
    vec4 t = clamp((to_x * along.x + to_y * along.y) / max(dot(along, along), 1e-12), 0.0, 1.0);
    to_x -= t * along.x, to_y -= t * along.y;
    return Pen(0.5 * widthPx - sqrt(to_x * to_x + to_y * to_y), abs(to_x), abs(to_y));
}

/// The share of each quarter that the pen covers.
vec4 shares_of(Pen pen) {
    vec4 away = sqrt(pen.way_x * pen.way_x + pen.way_y * pen.way_y);
    vec4 larger = max(pen.way_x, pen.way_y) / max(away, 1e-6), smaller = min(pen.way_x, pen.way_y) / max(away, 1e-6);
    larger = mix(larger, vec4(1), lessThan(away, vec4(1e-6)));
    return share_within(2.0 * pen.over, larger, smaller) - share_within(2.0 * (pen.over - widthPx), larger, smaller);
}
//-- ink
const bool has_classes = false;
uniform highp usampler2D pieces;
uniform highp sampler2D thin;  // as strokes draws it
out vec4 line;

/// Whether a pixel lies between lines of one pixel that are less than two apart, which are to stay two at half;
/// `lined`: of those above, left, here, right and below, whether a line runs through, a bit each.
bool is_between(uint lined) {
    return keeps_half && widthPx <= 1.0 && (lined & 4u) == 0u && ((lined & 10u) == 10u || (lined & 17u) == 17u);
}

/// Whether the one piece of a cell goes from one side back to it, or to none: of lines of one pixel that is to stay at half.
bool is_spike(vec4 ends) {
    bvec4 at_side = greaterThan(abs(ends - 0.5), vec4(0.494));
    bvec2 on_one = equal(ends.xy, ends.zw);
    return keeps_half && widthPx <= 1.0 && (on_one.x && at_side.x || on_one.y && at_side.y || !(at_side.z || at_side.w));
}

/// Takes in what is drawn of thin parts.
void add_thin(inout vec4 shares, inout uint kind, vec4 drawn) {
    if (has_classes) {
        uvec4 words = uvec4(255.0 * drawn + 0.5);
        drawn = vec4(words >> 3) / 31.0;
        uint word = max(max(words.x, words.y), max(words.z, words.w));
        if (any(greaterThan(drawn, shares))) kind = word & 7u;
    }
    shares = max(shares, drawn);
}

void main() {
    int reach = int(ceil(0.5 * widthPx));
    ivec2 p = ivec2(gl_FragCoord.xy) + reach;
    Pen pen = Pen(vec4(-1), vec4(0), vec4(0));
    uint lined = 0u, kind = 0u;
    float least = 0.0, nearest = -1.0;
    uvec4 cell = uvec4(0);
    for (int x = -reach - 1, y = -reach; ; cell = uvec4(cell.yzw, 0)) {  // a piece, of whichever cell has the next
        for (; cell.x == 0u && (x < reach || y < reach); cell = texelFetch(pieces, p + ivec2(x, y), 0))
            if (++x > reach) x = -reach, ++y;
        if (cell.x == 0u) break;
        if (x * x + y * y <= 1) lined |= 1u << (2 * y + x + 2);
        vec4 ends = vec4(cell.x >> 24, cell.x >> 16 & 255u, cell.x >> 8 & 255u, cell.x & 255u) / 255.0;
        if (x == 0 && y == 0 && cell.y == 0u && is_spike(ends)) least = 0.45;
        Pen found = pen_of(ends.xy + vec2(x, y), ends.zw + vec2(x, y));
        float most = max(max(found.over.x, found.over.y), max(found.over.z, found.over.w));
        if (has_classes && most > nearest)
            nearest = most, kind = cell.x >> 24 & 1u | cell.x >> 15 & 2u | cell.x >> 6 & 4u;
        bvec4 is_further = greaterThan(found.over, pen.over);
        pen.over = mix(pen.over, found.over, is_further);
        pen.way_x = mix(pen.way_x, found.way_x, is_further), pen.way_y = mix(pen.way_y, found.way_y, is_further);
    }
    vec4 shares = shares_of(pen);
    if (has_thin) add_thin(shares, kind, texelFetch(thin, p, 0));
    float ink = clamp(dot(shares, vec4(0.25)), least, is_between(lined) ? 0.41 : 1.0);
    line = has_classes ? vec4(ink, float(kind) / 255.0, 0, 0) : vec4(ink);
}
