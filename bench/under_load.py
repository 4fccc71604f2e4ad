#!/usr/bin/python3
"""Are times the same beside other work? Runs `compare` in turns on a quiet machine and beside a busy loop on each
core, and prints how many cells hold their ratio to the yardstick within 1.15 of the quiet runs.

    bench/under_load.py [--turns 3] [--size 1280x720] MODEL...

A share is of the cells that are not marked. Ranks are of methods, by the geometric mean over cells; two of which one is
less than 1.05 times the other may change places.
"""

import argparse
import contextlib
import os
import subprocess
import sys
import tempfile
from itertools import combinations
from pathlib import Path

import numpy as np
import pandas as pd

PROGRAM = os.environ.get("INKBENCH", "build/release/inkbench")
CELL = ["method", "scene", "view"]
WITHIN = np.log(1.15)
NEIGHBOURS = np.log(1.05)
FIGURES = ["draw_ns_min", "draw_ns", "draw_ns_median", "draw_wall_ns"]


@contextlib.contextmanager
def busy(is_busy):
    loops = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(is_busy * os.cpu_count())]
    try:
        yield
    finally:
        for loop in loops:
            loop.kill()


def timed_cells(args, folder, is_busy):
    words = ["--size", args.size, "--views", "3", "--no-sweep", "--no-crosscheck", "--images", "none", "-q"]
    with busy(is_busy):
        done = subprocess.run([PROGRAM, "compare", *args.models, *words, "--out", folder], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"under_load: compare ended with {done.returncode}: {done.stderr}")
    rows = pd.read_csv(folder / "rows.csv", low_memory=False)
    return rows[rows.clock == "thread"].set_index(CELL)


def log_of(rows, time, unit=None):
    return np.log(rows[time] / (rows[unit] if unit else 1))


def mean_of(runs, *columns):
    return pd.concat([log_of(rows, *columns) for rows in runs], axis=1).mean(axis=1)


def moved_ranks(quiet, loaded, time):
    before, after = (log_of(rows, time).groupby("method").mean() for rows in (quiet, loaded))
    return sum((before[a] - before[b]) * (after[a] - after[b]) < 0 and abs(before[a] - before[b]) > NEIGHBOURS
               for a, b in combinations(before.index, 2))


def moved_ratios(quiet, loaded, time):
    """By which factor ratios of two methods' times over the views of a scene change; 95 % by no more."""
    apart = (log_of(loaded, time) - log_of(quiet, time)).groupby(["scene", "method"]).mean().unstack("method")
    return np.exp(np.nanquantile([(apart[a] - apart[b]).abs() for a, b in combinations(apart, 2)], .95))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("models", nargs="+", metavar="MODEL")
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--keep", type=Path, metavar="FOLDER", help="where the runs stay")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        runs = [[timed_cells(args, (args.keep or Path(folder)) / f"{turn}-{'busy' if is_busy else 'quiet'}", is_busy)
                 for is_busy in (False, True)] for turn in range(args.turns)]
    quiet = [pair[0] for pair in runs]
    print("| turn | figure | within 1.15 | changed ranks | ratios | raw | marked |\n|--:|---|--:|--:|--:|--:|--:|")
    for turn, (calm, loaded) in enumerate(runs, 1):
        is_sure = loaded.time_doubt.isna()
        for time in FIGURES:
            apart = (log_of(loaded, time, "yardstick_ns") - mean_of(quiet, time, "yardstick_ns")).abs()
            raw = np.exp((log_of(loaded, time) - mean_of(quiet, time)).abs().quantile(.95))
            print(f"| {turn} | {time} | {100 * (apart[is_sure] < WITHIN).mean():.1f} % | {moved_ranks(calm, loaded, time)} "
                  f"| {moved_ratios(calm, loaded, time):.2f} | {raw:.2f} | {100 * (~is_sure).mean():.0f} % |")
    print(f"\n{len(quiet[0])} cells a turn; raw: 95 % of cells change by no more than this factor, ratios: 95 % of the ratios "
          "of two methods over the views of a model.")


if __name__ == "__main__":
    main()
