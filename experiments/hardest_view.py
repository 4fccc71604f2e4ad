#!/usr/bin/python3
"""Prints how far each method falls on its hardest view of each model, as Markdown.

    experiments/hardest_view.py RUN [--crops OUT.png SCENE:METHOD...]

Reads hardest.csv of a run folder that `inkbench run experiments/hardest_view.toml` wrote. A cell has F over the
model's usual views, pooled, and F on the worst view that was found; the last line pools, and takes the least. With
--crops draws those worst views side by side: black right, red missing, blue false. Exit code 2: a folder is no such run.
"""

import json
import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

from run_tables import pooled_f, print_heads, read, refuse, words_of

CROP_PX = (300, 200)
CAPTION_PX = 16
VOCABULARY = json.loads((Path(__file__).resolve().parent.parent / "src/core/vocabulary.json").read_text())


def usual_text(looks):
    """F over the usual views that have a score, pooled."""
    counts = looks[(looks.phase == "usual") & looks.f_2px.notna()][["k_2px", "n_pred", "n_truth"]].sum()
    return f"{pooled_f(counts):.3f}" if counts.n_truth else "-"


def print_table(looks):
    methods = list(dict.fromkeys(looks.method))
    print_heads(["model"], [f"`{method}` usual, worst" for method in methods])
    worst = looks[looks["rank"] == 1]
    for scene in dict.fromkeys(looks.scene):
        cells = []
        for method in methods:
            own = looks[(looks.scene == scene) & (looks.method == method)]
            least = worst[(worst.scene == scene) & (worst.method == method)].f_2px
            cells.append(f"{usual_text(own)}, {least.iloc[0]:.3f}" if len(least) else f"{usual_text(own)}, -")
        print(f"| {scene} | {' | '.join(cells)} |")
    last = [f"{usual_text(looks[looks.method == m])}, {worst[worst.method == m].f_2px.min():.3f}" for m in methods]
    print(f"| all: pooled, least | {' | '.join(last)} |")


def colour(name):
    return tuple(int(VOCABULARY["marks"][name][i:i + 2], 16) for i in (1, 3, 5))


def crop_of(folder, look):
    """The view with its errors in colour, cut to where the lines are."""
    images = Path(folder) / "images" / look.shown_as / look["view"]
    truth, response, errors = (np.asarray(Image.open(images / name)) for name in
                               ("truth.png", f"{look.method}.png", f"{look.method}.errors.png"))
    kinds = [None, *(cause["kind"] for cause in VOCABULARY["causes"])]
    painted = np.full((*truth.shape, 3), 255, np.uint8)
    painted[(response > 127) & (truth != 7)] = (200, 203, 208)  # drawn, before it is thinned
    painted[(truth > 0) & (truth < 7)] = colour("right")
    for code, kind in enumerate(kinds):
        if kind:
            painted[errors == code] = colour("missing" if kind == "false_negatives" else "false")
    ys, xs = np.nonzero((truth > 0) | (errors > 0))
    width, height = CROP_PX
    left = int(np.clip((xs.min() + xs.max() - width) // 2, 0, truth.shape[1] - width))
    top = int(np.clip((ys.min() + ys.max() - height) // 2, 0, truth.shape[0] - height))
    return Image.fromarray(painted[top:top + height, left:left + width])


def draw_crops(folder, looks, wanted, out):
    width, height = CROP_PX
    columns = min(3, len(wanted))
    rows = -(-len(wanted) // columns)
    sheet = Image.new("RGB", (columns * (width + 6), rows * (height + CAPTION_PX + 6)), "white")
    for i, word in enumerate(wanted):
        scene, _, method = word.partition(":")
        found = looks[(looks.scene == scene) & (looks.method == method) & (looks["rank"] == 1)]
        if not len(found):
            refuse(f"{word}: no worst view (accepted: SCENE:METHOD of the run)")
        look = found.iloc[0]
        x, y = i % columns * (width + 6), i // columns * (height + CAPTION_PX + 6)
        ImageDraw.Draw(sheet).text((x + 2, y + 2), f"{method} on {scene}: F {look.f_2px:.3f}", fill="black")
        sheet.paste(crop_of(folder, look), (x, y + CAPTION_PX))
    sheet.save(out)


def main():
    words = words_of(__doc__)
    looks, = read(words[0], "hardest.csv", by="stress --hardest")
    if words[1:2] == ["--crops"] and len(words) > 3:
        draw_crops(words[0], looks, words[3:], words[2])
    elif len(words) > 1:
        refuse(f"{words[1]}: no such option (accepted: --crops OUT.png SCENE:METHOD...)")
    else:
        print_table(looks)


if __name__ == "__main__":
    sys.exit(main())
