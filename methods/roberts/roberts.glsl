// roberts in GLSL ES 3.00 (WebGL 2): diagonal differences of depth, guarded at grazing angles, and of normals.
//
// As decaudin.glsl: bits of 1/distance and of the normal in a texture RGBA32UI, then a pass over the image.
//// vertex
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform mat3 normalMatrix;
in vec3 position;
in vec3 normal;
out vec4 channels_w;

void main() {
    vec4 p_view = modelViewMatrix * vec4(position, 1);
    gl_Position = projectionMatrix * p_view;
    // Of a parallel camera far - depth takes the place of 1/distance; z may run from -1 to 1, or from 1 to 0.
    float z = projectionMatrix[2][2] < 0.0 ? 1.0 - gl_Position.z : gl_Position.z;
    float nearness = projectionMatrix[3][3] == 0.0 ? 1.0 : z / abs(projectionMatrix[2][2]);
    channels_w = vec4(nearness, normalize(normalMatrix * normal) * gl_Position.w);
}
//// fragment
precision highp float;
in vec4 channels_w;
layout(location = 0) out highp uvec4 drawn;

void main() {
    vec4 channels = channels_w * gl_FragCoord.w;  // linear on the screen
    drawn = floatBitsToUint(vec4(channels.x, gl_FrontFacing ? channels.yzw : -channels.yzw));
}
//// screen of surface8
//// lines
precision highp float;
precision highp int;
uniform highp usampler2D codes;
uniform mat4 cameraProjection;  // the projectionMatrix of the first pass
uniform vec2 size;  // of the image, px
out vec4 line;

vec4 at(ivec2 p) { return uintBitsToFloat(texelFetch(codes, clamp(p, ivec2(0), ivec2(size) - 1), 0)); }

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    ivec2 to[4] = ivec2[](ivec2(0), ivec2(1, 0), ivec2(0, -1), ivec2(1, -1));
    bool is_parallel = cameraProjection[3][3] != 0.0;
    float focal_px = 0.5 * size.y * cameraProjection[1][1], facing = 0.0;
    vec4 s[4];
    for (int i = 0; i < 4; ++i) {
        s[i] = at(p + to[i]);
        vec2 ray = is_parallel ? vec2(0) : (vec2(p + to[i]) + 0.5 - 0.5 * size) / focal_px;
        facing = max(facing, abs(dot(s[i].yzw, normalize(vec3(ray, -1)))));
    }
    vec4 cross_of = 0.5 * (abs(s[0] - s[3]) + abs(s[1] - s[2]));
    float most = max(max(s[0].x, s[1].x), max(s[2].x, s[3].x)), least = min(min(s[0].x, s[1].x), min(s[2].x, s[3].x));
    float distance_world = is_parallel ? 1.0 / (cameraProjection[1][1] * tan(radians(20.0))) : 1.0;
    float step_of = cross_of.x / (is_parallel ? distance_world : most) * facing - 1.0 / (focal_px * distance_world);
    float ratio = max(step_of / 0.0025, length(cross_of.yzw) / 0.2);
    line = vec4(least == 0.0 ? most > 0.0 : floor(64.0 * ratio) >= 74.0);
}
