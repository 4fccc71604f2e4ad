#!/usr/bin/python3
"""Prints how far F depends on the crease angle that truth and methods share.

    experiments/crease_angle.py build/release/inkbench METHODS [SCENE | MODEL | OPTION ...]

The truth calls an edge a crease from an angle on, and methods that know the mesh use the same angle: a home
advantage. Two tables in Markdown, F at 2 px of all views pooled. In the first, methods follow the truth's angle; at
180 degrees there are no creases, and F is of contours, boundaries, intersections and seams alone. In the second,
methods keep 40 degrees while the truth's angle moves. Each table has a line for each part of the suite that took part.
METHODS is a list a,b as `inkbench compare` takes it, and so are scenes and options, such as --views 1. Without scenes:
the catalogue. Exit code 2: the program refused.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import pandas as pd

ANGLES_DEG = (20, 30, 40, 50, 60, 180)
BASELINES = ("none", "oracle")
SCORED = {0, 3}  # exit codes of compare: done, and done without a score on some views


def pooled_f(folder):
    """F by method and part of a run folder, in the order of its rows."""
    rows = pd.read_csv(Path(folder) / "rows.csv")
    rows = rows[(rows.status == "ok") & ~rows.method.isin(BASELINES)]
    sums = rows.groupby(["method", "split"], sort=False)[["k_2px", "n_pred", "n_truth"]].sum()
    return 2 * sums.k_2px / (sums.n_pred + sums.n_truth)


def measure(program, methods, scenes, angle_deg, settings):
    """F by method and part with the truth's creases from `angle_deg` on."""
    with tempfile.TemporaryDirectory() as folder:
        words = [program, "compare", *scenes, "--methods", methods,
                 "--crease", str(angle_deg), *settings, "--no-sweep", "--no-crosscheck", "--quiet",
                 "--images", "none", "--repetitions", "1", "--out", folder]
        ran = subprocess.run(words, capture_output=True, text=True)
        if ran.returncode not in SCORED:
            print(ran.stderr.strip(), file=sys.stderr)
            raise SystemExit(2)
        return pooled_f(folder)


def main():
    if len(sys.argv) < 3:
        print(__doc__.strip(), file=sys.stderr)
        raise SystemExit(2)
    program, methods, scenes = sys.argv[1], sys.argv[2], sys.argv[3:] or ["catalogue"]
    for settings in ([], ["--set", "crease_deg=40"]):
        print("| method | part | " + " | ".join(f"{angle} deg" for angle in ANGLES_DEG) + " |")
        print("|---|---|" + "--:|" * len(ANGLES_DEG), flush=True)
        found = pd.concat([measure(program, methods, scenes, angle, settings) for angle in ANGLES_DEG],
                          axis=1)
        for (method, part), values in zip(found.index, found.to_numpy()):
            print(f"| `{method}` | {part} | " + " | ".join(f"{value:.3f}" for value in values) + " |")
        print(flush=True)


if __name__ == "__main__":
    main()
