#!/usr/bin/python3
"""Prints how far F moves when scene, camera and image are mirrored: thinning has a handedness.

    experiments/mirrored_views.py build/release/inkbench [SCENE ...] [--size 640x360]

Each scene (default: the catalogue) is exported, and its first view compared twice, all methods at their own settings:
as it is, and with mesh and camera mirrored in x = 0. A column for the largest change of F on one view, one for the
standard deviation of these changes over the views, and one for the change of the pooled F. The last one is half the
95 % interval of the pooled F over scenes (drawn 2000 times): what mirroring adds to it, if both are independent, is
the root of the sum of their squares. Exit code 2: the program refused.
"""

import argparse
import json
import sys
import tempfile
from pathlib import Path

import numpy as np
import pandas as pd

from run_tables import compared, print_heads, said


def mirror(source, target):
    """The OBJ file with x turned round, and its faces too, so that outside stays outside."""
    with open(source, encoding="utf-8") as lines, open(target, "w", encoding="utf-8") as out:
        for line in lines:
            kind, *words = line.split() or [""]
            if kind in ("v", "vn"):
                x = words[0][1:] if words[0].startswith("-") else "-" + words[0]
                line = " ".join([kind, x, *words[1:]]) + "\n"
            elif kind == "f":
                line = " ".join([kind, *reversed(words)]) + "\n"
            out.write(line)


def compare(program, mesh, camera, size):
    def triple(values):
        return ",".join(repr(float(v)) for v in values)
    rows = compared(
        program, mesh, f"--eye={triple(camera['eye'])}", f"--target={triple(camera['target'])}",
        f"--up={triple(camera['up'])}", f"--fov={camera['fov_y_deg']!r}", "--size", size, "--no-cache")
    return rows.set_index("method")[["k_2px", "n_pred", "n_truth"]]


def both_sides(program, scene, size, folder):
    """Counts of each method on a view as it is and mirrored; None where the view has no score."""
    exported = folder / "exported"
    lines = said([program, "export", scene, "--views", "1", "--size", size, "-o", exported]).splitlines()
    view_folder = exported / lines[1].split(",")[-1]
    camera = json.loads((view_folder / "camera.json").read_text())["camera"]
    mesh = view_folder.parent / "mesh.obj"
    mirrored = folder / "mirrored.obj"
    mirror(mesh, mirrored)
    other = {name: [-value[0], *value[1:]] if name in ("eye", "target", "up") else value for name, value in camera.items()}
    a = compare(program, mesh, camera, size)
    b = compare(program, mirrored, other, size)
    return a.join(b, rsuffix="_mirrored", how="inner") if len(a) and len(b) else None


def f(counts, suffix=""):
    return 2 * counts[f"k_2px{suffix}"] / (counts[f"n_pred{suffix}"] + counts[f"n_truth{suffix}"])


def half_interval(counts, random):
    drawn = [f(counts.iloc[random.integers(0, len(counts), len(counts))].sum()) for _ in range(2000)]
    return (np.quantile(drawn, 0.975) - np.quantile(drawn, 0.025)) / 2


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--size", default="640x360")
    arguments = parser.parse_args()
    listed = json.loads(said([arguments.program, "list", "scenes", "--json"]))
    scenes = arguments.scenes or [scene["name"] for scene in listed["scenes"]]
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for scene in scenes:
            counts = both_sides(arguments.program, scene, arguments.size, Path(folder))
            if counts is not None:
                found.append(counts.assign(scene=scene).reset_index())
            print(f"{scene}: done", file=sys.stderr)
    all_counts = pd.concat(found)
    random = np.random.default_rng(0)
    print_heads(["method"], ["views", "largest", "deviation", "pooled", "half interval", "with mirroring"])
    for method, counts in all_counts.groupby("method", sort=False):
        counts = counts.drop(columns=["method", "scene"])
        change = f(counts, "_mirrored") - f(counts)
        pooled = f(counts.sum(), "_mirrored") - f(counts.sum())
        half = half_interval(counts, random)
        print(f"| `{method}` | {len(counts)} | {change.abs().max():.4f} | {change.std():.4f} | {pooled:+.4f} | {half:.4f} | "
              f"{np.hypot(half, pooled):.4f} |")


if __name__ == "__main__":
    main()
