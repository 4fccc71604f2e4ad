#!/usr/bin/python3
"""Prints at which threshold each method of some runs makes the fewest errors, every kind of scene counting alike.

    inkbench compare --scenes train --no-sweep --no-crosscheck --size 1280x720 --out train
    inkbench run experiments/real.toml
    experiments/thresholds.py train inkbench-out/real

One line of Markdown per method: its own threshold, the best one, and the square of the mean root of 1 - F at both, over
the training scenes of the runs (those of split `train`), the mean over kinds of the mean over each kind's scenes. This
is what `inkbench tune --objective kinds` lowers: pooled pixels would let one scene of many lines decide for all others.
`gain` is the 95 % interval of the difference of the mean roots, scenes of each kind resampled 2000 times. Shipped
thresholds are found so; one stays as long as that interval holds 0. Exit code 2: a folder is no such run.
"""

import numpy as np
import pandas as pd

from run_tables import BASELINES, print_heads, read, scored, words_of


def roots(lines):
    """The root of 1 - F of each scene, under its kind."""
    sums = lines.groupby(["scene_kind", "scene"])[["k", "n_pred", "n_truth"]].sum()
    error = 1 - 2 * sums.k / (sums.n_pred + sums.n_truth).clip(lower=1)
    return np.sqrt(error.clip(lower=0))


def mean_of_kinds(of_scenes):
    return of_scenes.groupby("scene_kind").mean().mean()


def gain_interval(own, best):
    """The 95 % interval of the mean over kinds of own - best, the scenes of each kind resampled."""
    random = np.random.default_rng(0)
    kinds = [of.to_numpy() for _, of in (own - best).groupby("scene_kind")]
    drawn = [of[random.integers(len(of), size=(2000, len(of)))].mean(axis=1) for of in kinds]
    return np.quantile(np.mean(drawn, axis=0), [0.025, 0.975])


def training_lines(run):
    """The curves of a run's training scenes, with what the rows say of them."""
    rows, curves = read(run, "rows.csv", "curves.csv")
    rows = scored(rows, BASELINES)
    facts = rows[rows.split == "train"][["cell", "method", "scene", "scene_kind", "threshold"]]
    return curves.merge(facts.rename(columns={"threshold": "own"}), on="cell", suffixes=("", "_of_row"))


def main():
    lines = pd.concat([training_lines(run) for run in words_of(__doc__)])
    print_heads(["method"], ["own", "its error", "best", "its error", "gain"])
    for method, of in lines.groupby("method"):
        by_threshold = of.groupby("threshold").apply(roots)
        # Line i of a curve is of an edge response of i percent of 255, rounded up.
        by_threshold.index = np.ceil(2.55 * by_threshold.index).astype(int)
        errors = by_threshold.apply(mean_of_kinds, axis=1) ** 2
        own = int(of.own.iloc[0])
        nearest = errors.index[np.abs(errors.index - own).argmin()]
        best = errors.idxmin()
        low, high = gain_interval(by_threshold.loc[nearest], by_threshold.loc[best])
        print(f"| `{method}` | {own} | {errors[nearest]:.4f} | {best} | {errors[best]:.4f} | {low:+.4f} to {high:+.4f} |")


if __name__ == "__main__":
    main()
