// label8 in GLSL ES 3.00 (WebGL 2): a line wherever labels of smooth patches differ.
//
// The mesh is drawn by `vertex` and `fragment` into a texture R8UI, cleared to 0, one column and one row
// larger than the image: its samples are the corners of pixels. Depth test, both sides, no multisampling.
// Then three vertices are drawn over the image by `screen` and `lines`. Names are those of three.js.
//// vertex of surface8
//// fragment of surface8
//// screen of surface8
//// lines
precision highp float;
uniform highp usampler2D codes;
out vec4 line;

uint label_at(ivec2 p) { return texelFetch(codes, p, 0).r; }

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    uint a = label_at(p), b = label_at(p + ivec2(1, 0));
    uint c = label_at(p + ivec2(0, 1)), d = label_at(p + ivec2(1, 1));
    line = vec4(a != b || a != c || a != d);
}
