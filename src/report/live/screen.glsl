// A part of the page's picture: the fill, and lines over it, as wide as they are asked for.
//// screen of surface8
//// lines
precision highp float;
precision highp int;
uniform sampler2D fill, mask;
uniform vec2 origin;  // of the part in the canvas, px
uniform vec2 size;    // of the part, px
uniform int lineWidthPx;
uniform vec3 lineColors[6];  // without a class, then by its number
uniform int hasFill, hasLines;
uniform int isDown;  // the rows of the mask
out vec4 color;

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy - origin);
    color = hasFill == 1 ? texelFetch(fill, p, 0) : vec4(1);
    if (hasLines == 0) return;
    vec2 line = vec2(0);  // ink, class / 255
    float radius = 0.5 * float(lineWidthPx);
    int from = -(lineWidthPx - 1) / 2, to = lineWidthPx / 2;
    for (int y = from; y <= to; ++y)
        for (int x = from; x <= to; ++x) {
            vec2 off = vec2(x, y) - 0.5 * float(from + to);
            ivec2 at = clamp(p + ivec2(x, y), ivec2(0), ivec2(size) - 1);
            if (isDown == 1) at.y = int(size.y) - 1 - at.y;
            vec2 found = texelFetch(mask, at, 0).rg;
            bool is_over = found.r > line.r || (found.r == line.r && found.g < line.g);
            if (dot(off, off) <= radius * radius && is_over) line = found;
        }
    color = mix(color, vec4(lineColors[int(255.0 * line.g + 0.5)], 1), line.r);
}
