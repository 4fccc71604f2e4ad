// A part of the page's picture: the fill, and lines over it, as wide as they are asked for.
//// screen of surface8
//// lines
precision highp float;
precision highp int;
uniform sampler2D fill, mask;
uniform vec2 origin;  // of the part in the canvas, px
uniform vec2 size;    // of the part, px
uniform int lineWidthPx;
uniform vec3 lineColor;
uniform int hasFill, hasLines;
uniform int isDown;  // the rows of the mask
out vec4 color;

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy - origin);
    color = hasFill == 1 ? texelFetch(fill, p, 0) : vec4(1);
    if (hasLines == 0) return;
    float ink = 0.0, radius = 0.5 * float(lineWidthPx);
    int from = -(lineWidthPx - 1) / 2, to = lineWidthPx / 2;
    for (int y = from; y <= to; ++y)
        for (int x = from; x <= to; ++x) {
            vec2 off = vec2(x, y) - 0.5 * float(from + to);
            ivec2 at = clamp(p + ivec2(x, y), ivec2(0), ivec2(size) - 1);
            if (isDown == 1) at.y = int(size.y) - 1 - at.y;
            if (dot(off, off) <= radius * radius) ink = max(ink, texelFetch(mask, at, 0).r);
        }
    color = mix(color, vec4(lineColor, 1), ink);
}
