#!/usr/bin/env python3
"""Errors of polygon_offset over its factor and units, on the training scenes.

Usage: offset_errors.py INKBENCH WORK_FOLDER OUT_FOLDER [SIZE]

Runs `inkbench compare` once a cell, each in a run folder of its own under WORK_FOLDER (a run that is
finished there is not computed again), and writes offset_errors.csv and offset_errors.svg. Counts are
pooled over the views, one a scene.
"""

import csv
import pathlib
import subprocess
import sys

FACTORS = ["0", "-0.125", "-0.25", "-0.5", "-0.75", "-1", "-2", "-4", "-8"]
UNITS = ["0", "-1", "-16", "-64", "-256", "-1024", "-4096"]
PAGE = ("-0.5", "-1")  # the page's own: -w/2, and one unit
SCENES = ("sphere,balls,torus,cube,cylinder,cone,blocks,horizon,tiles,layers,hills,soup,gear,"
          "figure")


def run_cell(inkbench, folder, size, factor, units):
    subprocess.run(
        [inkbench, "compare", "--scenes", SCENES, "--methods", "polygon_offset", "--views", "1",
         "--size", size, "--set", f"factor={factor}", "--set", f"units={units}", "--no-sweep",
         "--no-crosscheck", "--repetitions", "1", "--images", "none", "--out",
         str(folder)],
        check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def pooled(folder):
    """F, precision and recall over all views, and the recall of contours alone."""
    k = drawn = true = contour = contour_found = 0
    with open(folder / "rows.csv", newline="") as file:
        for row in csv.DictReader(file):
            if row["method"] != "polygon_offset":
                continue
            assert row["status"] == "ok", row
            k += int(row["k_2px"])
            drawn += int(row["n_pred"])
            true += int(row["n_truth"])
            if row["recall_contour"]:
                contour += int(row["truth_px_contour"])
                contour_found += float(row["recall_contour"]) * int(row["truth_px_contour"])
    return {"f_2px": 2 * k / (drawn + true), "precision_2px": k / drawn, "recall_2px": k / true,
            "recall_contour": contour_found / contour}


def shade(value, low, high):
    """White at `low`, deep blue at `high`."""
    share = (value - low) / (high - low) if high > low else 0
    return "#" + "".join(f"{round(255 + (to - 255) * share):02x}" for to in (31, 78, 150))


def heat_map(cells, key, title, left, top):
    values = [cell[key] for cell in cells.values()]
    low, high = min(values), max(values)
    best = max(cells, key=lambda cell: cells[cell][key])
    parts = [f'<g transform="translate({left},{top})">',
             f'<text x="0" y="-30" class="title">{title}</text>',
             '<text x="-8" y="-10">factor, units</text>']
    for column, units in enumerate(UNITS):
        parts.append(f'<text x="{95 + 56 * column}" y="-10" text-anchor="middle">{units}</text>')
    for line, factor in enumerate(FACTORS):
        y = 26 * line
        parts.append(f'<text x="58" y="{y + 18}" text-anchor="end">{factor}</text>')
        for column, units in enumerate(UNITS):
            value = cells[factor, units][key]
            ink = "#fff" if value - low > 0.55 * (high - low) else "#222"
            frame = ""
            if (factor, units) == PAGE:
                frame = ' stroke="#d60" stroke-width="3"'
            elif (factor, units) == best:
                frame = ' stroke="#000" stroke-width="3"'
            x = 68 + 56 * column
            parts.append(f'<rect x="{x}" y="{y + 2}" width="53" height="23" '
                         f'fill="{shade(value, low, high)}"{frame}/>')
            parts.append(f'<text x="{x + 26}" y="{y + 18}" text-anchor="middle" fill="{ink}">'
                         f'{value:.3f}</text>')
    return parts + ["</g>"]


def curve(cells, left, top):
    """F, precision and contours' recall against factor at the page's units."""
    width, height, low = 380, 180, 0.0
    def point(line, value):
        return (f"{left + width * line / (len(FACTORS) - 1):.1f},"
                f"{top + height * (1 - (value - low) / (1 - low)):.1f}")
    parts = [f'<text x="{left}" y="{top - 30}" class="title">along factor, units {PAGE[1]}</text>']
    for share in (0.0, 0.25, 0.5, 0.75, 1.0):
        y = top + height * (1 - (share - low) / (1 - low))
        parts.append(f'<path d="M{left} {y:.1f}h{width}" stroke="#ccc"/>'
                     f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">{share:g}</text>')
    for line, factor in enumerate(FACTORS):
        x = left + width * line / (len(FACTORS) - 1)
        parts.append(f'<text x="{x:.1f}" y="{top + height + 18}" text-anchor="middle">'
                     f'{factor}</text>')
    for row, (key, colour, name) in enumerate((("precision_2px", "#c33", "precision"),
                                               ("recall_contour", "#273", "recall of contours"),
                                               ("f_2px", "#1f4e96", "F, all lines"))):
        points = " ".join(point(line, cells[factor, PAGE[1]][key])
                          for line, factor in enumerate(FACTORS))
        parts.append(f'<polyline points="{points}" fill="none" stroke="{colour}" '
                     f'stroke-width="2"/><text x="{left + 130 * row}" '
                     f'y="{top + height + 40}" fill="{colour}">{name}</text>')
    return parts


def main(inkbench, work, out, size="640x360"):
    work, out = pathlib.Path(work), pathlib.Path(out)
    cells = {}
    for factor in FACTORS:
        for units in UNITS:
            folder = work / f"factor{factor}_units{units}"
            run_cell(inkbench, folder, size, factor, units)
            cells[factor, units] = pooled(folder)
    with open(out / "offset_errors.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["factor", "units", *cells[PAGE]])
        for (factor, units), cell in cells.items():
            writer.writerow([factor, units, *(f"{value:.4f}" for value in cell.values())])
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1010 640" '
             'font-family="sans-serif" font-size="13">',
             "<style>.title{font-weight:bold;font-size:15px}</style>",
             '<rect width="1010" height="640" fill="#fff"/>']
    parts += heat_map(cells, "f_2px", "F at 2 px, all lines", 20, 60)
    parts += heat_map(cells, "precision_2px", "precision: specks lower it", 530, 60)
    parts += heat_map(cells, "recall_contour", "recall of contours: show-through lowers it",
                      20, 375)
    parts += curve(cells, 590, 375)
    parts += ["</svg>"]
    (out / "offset_errors.svg").write_text("\n".join(parts) + "\n")
    best = max(cells, key=lambda cell: cells[cell]["f_2px"])
    for name, cell in (("page", PAGE), ("best", best)):
        values = " ".join(f"{key} {value:.4f}" for key, value in cells[cell].items())
        print(f"{name}: factor {cell[0]} units {cell[1]}: {values}")


if __name__ == "__main__":
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    main(*sys.argv[1:])
