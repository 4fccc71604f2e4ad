// surface8 in GLSL ES 3.00 (WebGL 2): a line wherever codes of surface distance differ by more than a step.
//
// The mesh is drawn by `vertex` and `fragment` into a texture R8UI, cleared to 0, one column and one row
// larger than the image: its samples are the corners of pixels. Depth test, both sides, no multisampling.
// Then three vertices are drawn over the image by `screen` and `lines`. Names are those of three.js.
//// vertex
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec2 size;  // of the image, px
in vec3 position;
in float _ink;  // the code of its triangle: what inkbench bake --codes writes
flat out highp uint code;

void main() {
    code = uint(_ink + 0.5);
    gl_Position = projectionMatrix * (modelViewMatrix * vec4(position, 1));
    gl_Position.xy *= size / (size + 1.0);  // half a pixel more on every side
}
//// fragment
flat in highp uint code;
layout(location = 0) out highp uint drawn;

void main() { drawn = code; }
//// screen
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0, 1); }
//// lines
precision highp float;
precision highp int;
uniform highp usampler2D codes;
out vec4 line;

int code_at(ivec2 p) { return int(texelFetch(codes, p, 0).r); }

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    int a = code_at(p), b = code_at(p + ivec2(1, 0));
    int c = code_at(p + ivec2(0, 1)), d = code_at(p + ivec2(1, 1));
    int most = max(max(abs(a - b), abs(a - c)), max(abs(d - b), abs(d - c)));
    line = vec4(min(64 * most, 255) >= 128);
}
