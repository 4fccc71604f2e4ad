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

void main() {
    drawn = code;
    drawn_depth = floatBitsToUint(nearness * gl_FragCoord.w);
}
//// screen
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0, 1); }
//// lines
precision highp float;
precision highp int;
uniform highp usampler2D codes, depths;
uniform mat4 cameraProjection;  // the projectionMatrix of the first pass
uniform vec2 size;
out vec4 line;

int code_at(ivec2 p) { return int(texelFetch(codes, p, 0).r); }
float q_at(ivec2 p) { return uintBitsToFloat(texelFetch(depths, clamp(p, ivec2(0), ivec2(size)), 0).r); }

bool is_line(ivec2 p, ivec2 to) {
    float a = q_at(p), b = q_at(p + to), j = b - a, s0 = a - q_at(p - to), s1 = q_at(p + 2 * to) - b;
    float jump_world = 8.0 / (0.5 * size.y * cameraProjection[1][1]);  // 8 px, at distance 1
    float least = jump_world * (cameraProjection[3][3] == 0.0 ? max(a, b) : 1.0);
    bool jumps = max(j - max(s0, s1), min(s0, s1) - j) > least && abs(j) > 2.0 * max(abs(s0), abs(s1));
    return jumps || abs(code_at(p) - code_at(p + to)) >= 2;
}

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy), x = ivec2(1, 0), y = ivec2(0, 1);
    line = vec4(is_line(p, x) || is_line(p, y) || is_line(p + y, x) || is_line(p + x, y));
}
