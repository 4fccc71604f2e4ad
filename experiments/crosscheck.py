#!/usr/bin/env python3
"""Prints the tables of crosscheck.md: what `inkbench truth --crosscheck` says of scenes and models.

    experiments/crosscheck.py build/release/inkbench [SCENE | MODEL ...]

One line of Markdown per scene and view: length of the truth, what either construction has of the
other's lines, the confirmed disagreement, what the check abstains on, and the least times of both in
three runs. Views
are `view0` to `view2` of a model file and the first of a catalogue scene. Stops at the first view
that cannot be traced, with the program's own message.
"""

import re
import subprocess
import sys
from pathlib import Path

RUNS = 3
SCENES = ("cube torus teapot chess blocks horizon fence room soup tree figure rocket").split()
ALL = re.compile(r"^all\s+([\d.]+)\s+([\d.]+) %\s+[\d.]+\s+([\d.]+) %", re.M)
RATE = re.compile(r"disagreement ([\d.]+) % .*abstains on ([\d.]+) %", re.S)
TRACED = re.compile(r"^traced in ([\d.]+) s", re.M)
LOOKED = re.compile(r"^looked \d+ times in ([\d.]+) s", re.M)


def check(program: str, scene: str, view: list[str]) -> str:
    """A line of the table for one view."""
    words = [program, "truth", scene, *view, "--crosscheck", "--no-cache", "--quiet"]
    times = []
    for _ in range(RUNS):
        ran = subprocess.run(words, capture_output=True, text=True)
        found = [pattern.search(ran.stdout) for pattern in (ALL, RATE, TRACED, LOOKED)]
        if not all(found):
            sys.exit(f"{scene}: {ran.stderr.strip() or ran.stdout.strip()}")
        times.append([float(found[i].group(1)) for i in (2, 3)])
    truth_s, check_s = (min(column) for column in zip(*times))
    _, view = ran.stdout.split("\n", 1)[0].rsplit(" ", 1)
    (truth_px, seen, traced), (rate, abstained) = (m.groups() for m in found[:2])
    return (f"| {Path(scene).name} | {view} | {truth_px} | {seen} | {traced} | {rate} | {abstained} |"
            f" {truth_s:.3f} | {check_s:.3f} | {check_s / truth_s:.1f} |")


def main() -> None:
    if len(sys.argv) < 2:
        sys.exit(__doc__.strip())
    program, scenes = sys.argv[1], sys.argv[2:] or SCENES
    print("| scene | view | truth px | seen % | traced % | disagree % | abstain % | truth s | check s"
          " | ratio |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|")
    for scene in scenes:
        is_file = Path(scene).suffix != ""
        for view in [["--view", f"view{i}"] for i in range(3)] if is_file else [[]]:
            print(check(program, scene, view), flush=True)


if __name__ == "__main__":
    main()
