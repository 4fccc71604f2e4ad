#!/usr/bin/python3
"""Prints how far two predictions of missed creases are off, by method and part of the suite.

    experiments/law_of_misses.py RUN [RUN ...]

RUN is a run folder with cancellation.csv. *measured* is the share of true crease pixels that the image missed.
*code* is what the study predicts: it evaluates the rounded code at the pixel centres beside each line. *law* knows
nothing but the weights and the threshold: sin(s/2) / sin(d/2) for a crease that deviates by d from flat, where s is
the deviation that the code keeps silent in every direction. Each bin of ten degrees counts with its middle. The last
two columns are the largest distances from what was measured on one scene with at least 500 true crease pixels, in
percentage points. Exit code 2: a folder has no such table.
"""

import numpy as np
import pandas as pd

from run_tables import print_heads, read, words_of

BIN_DEG = 10
FEWEST_PX = 500


def read_creases(folder):
    rows, lines = read(folder, "rows.csv", "cancellation.csv")
    lines = lines.merge(rows[["cell", "method", "scene", "split"]], on="cell")
    lines = lines[lines["class"] == "crease"].copy()
    half_d = np.radians((lines.dihedral_low_deg + BIN_DEG / 2) / 2)
    half_s = np.radians(lines.silent_deg / 2)
    lines["by_law"] = lines.n_truth * np.minimum(1, np.sin(half_s) / np.sin(half_d))
    return lines


def rates(lines, by):
    """Shares in %, of all true pixels of each group."""
    sums = lines.groupby(by, sort=False)[["n_truth", "measured_missed", "predicted_missed", "by_law"]].sum()
    found = pd.DataFrame({name: 100 * sums[column] / sums.n_truth
                          for name, column in (("measured", "measured_missed"), ("code", "predicted_missed"),
                                               ("law", "by_law"))})
    found["n_truth"] = sums.n_truth
    return found


def main():
    lines = pd.concat([read_creases(folder) for folder in words_of(__doc__)])
    by_part = rates(lines, ["method", "split"])
    by_scene = rates(lines, ["method", "split", "scene"]).sort_index()
    by_scene = by_scene[by_scene.n_truth >= FEWEST_PX]
    print_heads(["method", "part"], ["measured", "code", "law", "code, worst scene", "law, worst scene"])
    for (method, part), row in by_part.iterrows():
        worst = []
        for name in ("code", "law"):
            scenes = by_scene.loc[(method, part)] if (method, part) in by_scene.index else by_scene.iloc[:0]
            off = (scenes[name] - scenes.measured).abs()
            worst.append(f"{off.max():.1f} ({off.idxmax()})" if len(off) else "-")
        print(f"| `{method}` | {part} | {row.measured:.1f} | {row.code:.1f} | {row.law:.1f} | "
              + " | ".join(worst) + " |")


if __name__ == "__main__":
    main()
