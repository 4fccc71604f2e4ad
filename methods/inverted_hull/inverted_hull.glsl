// inverted_hull in GLSL ES 3.00 (WebGL 2): back faces moved out along their normals, behind the front faces.
//
// The mesh is drawn twice by `vertex` and `fragment` into one texture R8UI of the image's size, cleared to 0,
// with a depth test and no multisampling: front faces with widthPx 0 and ink 0, then back faces with widthPx
// 2 and ink 1, which the depth test keeps where they are nearer. `screen` and `lines` read that texture.
//// vertex
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform mat3 normalMatrix;
uniform vec2 size;      // of the image, px
uniform float widthPx;  // how far vertices move
in vec3 position;
in vec3 normal;  // one for all triangles at a vertex, or the hull splits

void main() {
    vec4 p_view = modelViewMatrix * vec4(position, 1);
    float px_per_world = 0.5 * size.y * projectionMatrix[1][1];
    if (projectionMatrix[3][3] == 0.0) {
        float near = abs(projectionMatrix[3][2]) / (abs(projectionMatrix[2][2]) + 1.0);
        px_per_world /= max(-p_view.z, near);
    }
    p_view.xyz += widthPx / px_per_world * normalize(normalMatrix * normal);
    gl_Position = projectionMatrix * p_view;
}
//// fragment
uniform highp uint ink;
layout(location = 0) out highp uint drawn;

void main() { drawn = ink; }
//// screen of surface8
//// lines
precision highp float;
uniform highp usampler2D codes;
out vec4 line;

void main() { line = vec4(texelFetch(codes, ivec2(gl_FragCoord.xy), 0).r > 0u); }
