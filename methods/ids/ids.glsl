// ids in GLSL ES 3.00 (WebGL 2): a line on the nearer side of every border between two ids.
//
// The mesh is drawn by `vertex` and `fragment` into a texture RG32UI of the image's size, cleared to 0: ids,
// and the bits of 1/distance. Depth test, both sides, no multisampling. Then three vertices are drawn over
// the image by `screen` and `lines`. Names are those of three.js.
//// vertex
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
in uint id;  // of its triangle's smooth patch within its object, from 0
flat out highp uint drawn_id;
out float nearness;

void main() {
    drawn_id = id + 1u;  // 0 is the sky
    vec4 p_view = modelViewMatrix * vec4(position, 1);
    gl_Position = projectionMatrix * p_view;
    // Of a parallel camera far - depth takes the place of 1/distance; z may run from -1 to 1, or from 1 to 0.
    float z = projectionMatrix[2][2] < 0.0 ? 1.0 - gl_Position.z : gl_Position.z;
    nearness = projectionMatrix[3][3] == 0.0 ? 1.0 : z / abs(projectionMatrix[2][2]);
}
//// fragment
precision highp float;
flat in highp uint drawn_id;
in float nearness;
layout(location = 0) out highp uvec2 drawn;

void main() { drawn = uvec2(drawn_id, floatBitsToUint(nearness * gl_FragCoord.w)); }
//// screen of surface8
//// lines
precision highp float;
precision highp int;
uniform highp usampler2D codes;
uniform vec2 size;  // of the image, px
out vec4 line;

uvec2 id_at(ivec2 p) { return texelFetch(codes, clamp(p, ivec2(0), ivec2(size) - 1), 0).rg; }

/// Whether the pixel is the nearer of two that differ, or has the lower id of two as near. Bits of floats above
/// 0 are in the order of the floats.
bool owns(uvec2 here, uvec2 other) {
    return here.x != other.x && (here.y > other.y || (here.y == other.y && here.x < other.x));
}

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy), x = ivec2(1, 0), y = ivec2(0, 1);
    uvec2 here = id_at(p);
    line = vec4(owns(here, id_at(p + x)) || owns(here, id_at(p - x)) || owns(here, id_at(p + y)) ||
                owns(here, id_at(p - y)));
}
