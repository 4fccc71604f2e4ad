#!/usr/bin/env python3
"""Prints the tables of crosscheck.md: what `inkbench truth --crosscheck` says of scenes and models.

    experiments/crosscheck.py build/release/inkbench [--rows FILE] [SCENE | MODEL ...]

One line of Markdown per scene and view: length of the truth, what either construction has of the
other's lines, the confirmed disagreement, what the check abstains on, and the least times of both in
three runs. Views are `view0` to `view2` of a model file and the first of a catalogue scene. With
--rows, lines that FILE has are taken from there and new ones added to it, so that a table can be
made in parts. Stops at the first view that cannot be traced, with the program's own message.
"""

import argparse
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


def check(program: str, scene: str, view: str | None) -> str:
    """A line of the table for one view, the first where it is None."""
    named = ["--view", view] if view else []
    words = [program, "truth", scene, *named, "--crosscheck", "--no-cache", "--quiet"]
    times = []
    for _ in range(RUNS):
        ran = subprocess.run(words, capture_output=True, text=True)
        found = [pattern.search(ran.stdout) for pattern in (ALL, RATE, TRACED, LOOKED)]
        if not all(found):
            sys.exit(f"{scene}: {ran.stderr.strip() or ran.stdout.strip()}")
        times.append([float(found[i].group(1)) for i in (2, 3)])
    truth_s, check_s = (min(column) for column in zip(*times))
    _, seen_view = ran.stdout.split("\n", 1)[0].rsplit(" ", 1)
    (truth_px, seen, traced), (rate, abstained) = (m.groups() for m in found[:2])
    return (f"| {Path(scene).name} | {seen_view} | {truth_px} | {seen} | {traced} | {rate} |"
            f" {abstained} | {truth_s:.3f} | {check_s:.3f} | {check_s / truth_s:.1f} |")


def rows_of(path: Path | None) -> list[str]:
    """The lines that a file of them has; none without a file."""
    return path.read_text().splitlines() if path and path.exists() else []


def find_row(rows: list[str], scene: str, view: str | None) -> str | None:
    """The line of a view, if it is among them."""
    begin = f"| {Path(scene).name} | {view or ''}"
    return next((row for row in rows if row.startswith(begin)), None)


def main() -> None:
    parser = argparse.ArgumentParser(usage=__doc__.strip())
    parser.add_argument("program")
    parser.add_argument("scenes", nargs="*", default=SCENES)
    parser.add_argument("--rows", type=Path)
    args = parser.parse_intermixed_args()
    print("| scene | view | truth px | seen % | traced % | disagree % | abstain % | truth s | check s"
          " | ratio |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|")
    known = rows_of(args.rows)
    for scene in args.scenes:
        is_file = Path(scene).suffix != ""
        for view in [f"view{i}" for i in range(3)] if is_file else [None]:
            row = find_row(known, scene, view)
            if row is None:
                row = check(args.program, scene, view)
                if args.rows:
                    with args.rows.open("a") as file:
                        print(row, file=file)
            print(row, flush=True)


if __name__ == "__main__":
    main()
