// mote4 in GLSL ES 3.00 (WebGL 2): depth and normal summed in a byte, and a Laplacian over it.
//
// The mesh is drawn by `vertex` and `fragment` into a texture R8UI of the image's size, cleared to 0. Depth
// test, both sides, no multisampling. Then three vertices are drawn over the image by `screen` and `lines`.
// Names are those of three.js.
//// vertex
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform mat3 normalMatrix;
uniform vec2 depthRange;  // distances along the view at which depth is 1 and 0
in vec3 position;
in vec3 normal;
out vec2 packed_w;

void main() {
    vec4 p_view = modelViewMatrix * vec4(position, 1);
    gl_Position = projectionMatrix * p_view;
    float depth_w = (depthRange.y + p_view.z) / (depthRange.y - depthRange.x);
    if (projectionMatrix[3][3] == 0.0) depth_w *= depthRange.x;  // 1/distance, times distance
    // Times w, and in the fragment over w: linear on the screen.
    packed_w = vec2(63.0 * depth_w, dot(normalize(normalMatrix * normal), vec3(31.5)) * gl_Position.w);
}
//// fragment
precision highp float;
in vec2 packed_w;
layout(location = 0) out highp uint drawn;

void main() {
    vec2 parts = packed_w * gl_FragCoord.w;
    float normals = gl_FrontFacing ? parts.y : -parts.y;
    drawn = uint(clamp(floor(parts.x + normals + 3.0 * 31.5 + 0.5), 0.0, 255.0));
}
//// screen of surface8
//// lines
precision highp float;
precision highp int;
uniform highp usampler2D codes;
uniform vec2 size;  // of the image, px
out vec4 line;

int code_at(ivec2 p) { return int(texelFetch(codes, clamp(p, ivec2(0), ivec2(size) - 1), 0).r); }

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy), x = ivec2(1, 0), y = ivec2(0, 1);
    int laplacian = 4 * code_at(p) - code_at(p + x) - code_at(p - x) - code_at(p + y) - code_at(p - y);
    line = vec4((abs(laplacian) & ~3) >= 6);  // two low bits are cut off
}
