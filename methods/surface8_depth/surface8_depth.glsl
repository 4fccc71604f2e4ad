// surface8_depth in GLSL ES 3.00 (WebGL 2): lines of surface8, and where depth jumps.
//
// As surface8.glsl, into two textures at once: R8UI for codes and R32UI for the bits of 1/distance.
//// vertex
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec2 size;  // of the image, px
in vec3 position;
in float _ink;  // the code of its triangle, 2..255: what inkbench bake --codes surface8 writes
flat out highp uint code;
out float nearness;

void main() {
    code = uint(_ink + 0.5);
    vec4 p_view = modelViewMatrix * vec4(position, 1);
    gl_Position = projectionMatrix * p_view;
    gl_Position.xy *= size / (size + 1.0);  // half a pixel more on every side
    // Of a parallel camera far - depth takes the place of 1/distance; z may run from -1 to 1, or from 1 to 0.
    float z = projectionMatrix[2][2] < 0.0 ? 1.0 - gl_Position.z : gl_Position.z;
    nearness = projectionMatrix[3][3] == 0.0 ? 1.0 : z / abs(projectionMatrix[2][2]);
}
//// fragment
precision highp float;
flat in highp uint code;
in float nearness;
layout(location = 0) out highp uint drawn;
layout(location = 1) out highp uint drawn_depth;

void main() { drawn = code, drawn_depth = floatBitsToUint(nearness * gl_FragCoord.w); }
//// screen of surface8
//// lines
precision highp float;
precision highp int;
uniform highp usampler2D codes, depths;
uniform mat4 cameraProjection;  // the projectionMatrix of the first pass
uniform vec2 size;
out vec4 line;

int code_at(ivec2 p) { return int(texelFetch(codes, p, 0).r); }
float q_at(int x, int y) { return uintBitsToFloat(texelFetch(depths, ivec2(x, y), 0).r); }

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy), x = ivec2(1, 0), y = ivec2(0, 1);
    int c00 = code_at(p), c10 = code_at(p + x), c01 = code_at(p + y), c11 = code_at(p + x + y);
    int most = max(max(abs(c00 - c10), abs(c00 - c01)), max(abs(c11 - c10), abs(c11 - c01)));
    line = vec4(most >= 2);
    if (most >= 2 || c00 == 0) return;  // a line by its codes, or all sky
    // Depths of the square and, of each of its four sides, those before and after in line. A jump is 8 px deep.
    vec4 q = vec4(q_at(p.x, p.y), q_at(p.x + 1, p.y), q_at(p.x, p.y + 1), q_at(p.x + 1, p.y + 1));
    ivec2 first = max(p - 1, 0), last = min(p + 2, ivec2(size));
    vec4 before = vec4(q_at(first.x, p.y), q_at(first.x, p.y + 1), q_at(p.x, first.y), q_at(p.x + 1, first.y));
    vec4 after = vec4(q_at(last.x, p.y), q_at(last.x, p.y + 1), q_at(p.x, last.y), q_at(p.x + 1, last.y));
    vec4 a = q.xzxy, b = q.ywzw, j = b - a, s0 = a - before, s1 = after - b;
    vec4 least = 16.0 / (size.x * cameraProjection[0][0]) * (cameraProjection[3][3] == 0.0 ? max(a, b) : vec4(1));
    vec4 over = min(max(j - max(s0, s1), min(s0, s1) - j) - least, abs(j) - 2.0 * max(abs(s0), abs(s1)));
    line = vec4(max(max(over.x, over.y), max(over.z, over.w)) > 0.0);
}
