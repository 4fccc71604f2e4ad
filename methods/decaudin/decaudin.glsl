// decaudin in GLSL ES 3.00 (WebGL 2): Decaudin's two operators over depth and normals in full.
//
// The mesh is drawn by `vertex` and `fragment` into a texture RGBA32UI of the image's size, cleared to 0: the
// bits of four floats. Depth test, both sides, no multisampling. Then three vertices are drawn over the
// image by `screen` and `lines`. Names are those of three.js.
//// vertex
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform mat3 normalMatrix;
uniform vec2 depthRange;  // distances along the view at which depth is 1 and 0
in vec3 position;
in vec3 normal;
out vec4 channels_w;

void main() {
    vec4 p_view = modelViewMatrix * vec4(position, 1);
    gl_Position = projectionMatrix * p_view;
    float depth_w = (depthRange.y + p_view.z) / (depthRange.y - depthRange.x);
    if (projectionMatrix[3][3] == 0.0) depth_w *= depthRange.x;  // 1/distance, times distance
    // Times w, and in the fragment over w: linear on the screen.
    channels_w = vec4(depth_w, normalize(normalMatrix * normal) * gl_Position.w);
}
//// fragment
precision highp float;
in vec4 channels_w;
layout(location = 0) out highp uvec4 drawn;

void main() {
    vec4 channels = channels_w * gl_FragCoord.w;
    drawn = floatBitsToUint(vec4(channels.x, gl_FrontFacing ? channels.yzw : -channels.yzw));
}
//// screen of surface8
//// lines
precision highp float;
precision highp int;
uniform highp usampler2D codes;
uniform vec2 size;  // of the image, px
out vec4 line;

void main() {
    vec4 at[25];
    for (int i = 0; i < 25; ++i) {
        ivec2 p = ivec2(gl_FragCoord.xy) + ivec2(i % 5, i / 5) - 2;
        uvec4 bits = texelFetch(codes, clamp(p, ivec2(0), ivec2(size) - 1), 0);
        at[i] = bits == uvec4(0) ? vec4(-1, 0, 0, 0) : uintBitsToFloat(bits);  // the sky lies beyond the far end
    }
    vec4 least = vec4(1e9), most = vec4(-1e9);
    for (int i = 0; i < 9; ++i) {
        int x = 6 + i % 3 + 5 * (i / 3);
        vec4 o = at[x], sides = abs(at[x - 5] - o) + abs(at[x - 1] - o) + abs(at[x + 1] - o) + abs(at[x + 5] - o);
        vec4 g = abs(at[x - 6] - o) + abs(at[x - 4] - o) + abs(at[x + 4] - o) + abs(at[x + 6] - o) + 2.0 * sides;
        least = min(least, g / 8.0), most = max(most, g / 8.0);
    }
    vec4 p = min((most - least) / vec4(0.02, vec3(0.25)), 1.0);
    p *= p;
    line = vec4(floor(255.0 * max(max(p.x, p.y), max(p.z, p.w)) + 0.5) >= 146.0);
}
