#!/bin/sh
# Makes experiments/sources/*.png: what each source shows, made again. From the root of a checkout:
#
#   experiments/sources.sh [MODELS]
#
# MODELS holds knight.mdl, faerie.md2 and kyonshi/lower.md3 (default: inkbench-out/models); without
# them TechnicalQuake's pictures are left out, with a word. Needs build/release/inkbench (or INKBENCH)
# and OpenImageIO's oiiotool. The errors of polygon_offset are a run: experiments/offset_errors.toml.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
models=${1:-$here/../inkbench-out/models}
inkbench=${INKBENCH:-$here/../build/release/inkbench}
out=$here/sources
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
size=400x225

# panel NAME SCENE OPTIONS...: one picture. What a method counted is printed.
panel() {
    name=$1
    scene=$2
    shift 2
    "$inkbench" draw "$scene" --size "$size" "$@" -o "$work/$name.png" >"$work/said"
    sed -n "2s|^|$name: |p" "$work/said"
}
# sheet FILE COLUMNSxROWS NAMES...: panels in one picture, row by row.
sheet() {
    file=$1
    grid=$2
    shift 2
    panels=
    for name in "$@"; do panels="$panels $work/$name.png"; done
    # shellcheck disable=SC2086 # names without blanks, one word each
    oiiotool $panels --mosaic:pad=4 "$grid" --attrib oiio:ColorSpace sRGB -o "$out/$file"
    echo "$out/$file"
}

# MOTE: the packed buffer, what the filter leaves of it, the picture.
for method in mote2 mote4; do
    panel $method.1 teapot --method $method --layer packed
    panel $method.2 teapot --method $method --layer filtered
    panel $method.3 teapot --method $method --shading gouraud --dither 565
    panel $method.4 figure --view close --method $method --layer packed
    panel $method.5 figure --view close --method $method --layer filtered
    panel $method.6 figure --view close --method $method --shading gouraud --dither 565
    sheet $method.png 3x2 $method.1 $method.2 $method.3 $method.4 $method.5 $method.6
done

size=380x285
# "Inked": raw, inked, inked and antialiased; then the lines alone, from too little depth bias to too much.
inked() {
    what=$1
    shift
    panel "$what.1" "$@" --shading gouraud --no-lines
    panel "$what.2" "$@" --shading gouraud --method polygon_offset
    panel "$what.3" "$@" --shading gouraud --method polygon_offset --antialias 4
    panel "$what.4" "$@" --method polygon_offset --set factor=-0.25
    panel "$what.5" "$@" --method polygon_offset
    panel "$what.6" "$@" --method polygon_offset --set factor=-8
    sheet "$what.png" 3x2 "$what.1" "$what.2" "$what.3" "$what.4" "$what.5" "$what.6"
}
inked offset_tree tree --view trunk
inked offset_figure figure --view close

# CoRgi. Widths are in samples, 4 x 4 a pixel; the fills give way by half a width.
size=480x270
lines="--method edge_list --antialias 4"
thick="--set width_contour_px=16 --set offset_factor=8"
# shellcheck disable=SC2086 # options
{
    panel corgi.1 rocket $lines --set crease_deg=0 --set width_contour_px=1 \
        --set offset_factor=2
    panel corgi.2 rocket $lines $thick --set crease_deg=180
    panel corgi.3 rocket $lines $thick --set width_crease_px=3
    panel corgi.4 rocket $lines $thick --set width_crease_px=3 --shading toon --set-shade by=patch
    panel corgi.5 rocket $lines $thick --set width_crease_px=3 --shading strokes \
        --set-shade by=patch --set-shade crossed_from=1
    panel corgi.6 rocket $lines $thick --set width_crease_px=3 --shading strokes \
        --set-shade by=patch
}
sheet corgi.png 2x3 corgi.1 corgi.2 corgi.3 corgi.4 corgi.5 corgi.6

# TechnicalQuake, on its kind of models.
if ! [ -f "$models/knight.mdl" ] || ! [ -f "$models/faerie.md2" ] ||
    ! [ -f "$models/kyonshi/lower.md3" ]; then
    echo "$models lacks knight.mdl, faerie.md2 or kyonshi/lower.md3: no quake_*.png" >&2
    exit 0
fi
knight=$models/knight.mdl
faerie=$models/faerie.md2
kyonshi=$models/kyonshi/lower.md3
size=220x275
row=0
for model in "$knight" "$faerie" "$kyonshi"; do
    row=$((row + 1))
    draw="--method edge_hash --antialias 4 --shading gooch"
    # shellcheck disable=SC2086 # options
    {
        panel shading.$row.1 "$model" $draw
        panel shading.$row.2 "$model" $draw --set-shade lit=warm
        panel shading.$row.3 "$model" $draw --set-shade lit=warm --set-shade splash_alpha=0.5
    }
done
sheet quake_shading.png 3x3 shading.1.1 shading.1.2 shading.1.3 \
    shading.2.1 shading.2.2 shading.2.3 shading.3.1 shading.3.2 shading.3.3
# Its edges from three sides, and what the tolerance of its weld does.
size=300x300
edges() {
    cell=$1
    shift
    panel "edges.$cell" "$@" --method edge_hash --layer edges
}
row=0
for model in "$knight" "$faerie" "$kyonshi"; do
    row=$((row + 1))
    for column in 1 2 3; do
        edges $row.$column "$model" --view view$((column - 1))
    done
done
edges 4.1 soup --set epsilon=0
edges 4.2 soup
edges 4.3 "$faerie" --set epsilon=0.01
sheet quake_edges.png 3x4 edges.1.1 edges.1.2 edges.1.3 edges.2.1 edges.2.2 edges.2.3 \
    edges.3.1 edges.3.2 edges.3.3 edges.4.1 edges.4.2 edges.4.3

frames() {
    who=$1
    model=$2
    shift 2
    for frame in "$@"; do
        panel "$who.$frame" "$model" --frame "$frame" --method edge_hash --antialias 4 \
            --shading gooch --set-shade lit=warm
    done
}
size=190x240
frames knight "$knight" 0 32 64 96
frames faerie "$faerie" 0 50 100 180
frames kyonshi "$kyonshi" 0 60 120 200
sheet quake_frames.png 4x3 knight.0 knight.32 knight.64 knight.96 \
    faerie.0 faerie.50 faerie.100 faerie.180 kyonshi.0 kyonshi.60 kyonshi.120 kyonshi.200
