#!/usr/bin/python3
"""Prints at which threshold each method of a run makes the fewest errors, every scene counting alike.

    inkbench compare --scenes train --no-sweep --no-crosscheck --size 1280x720 --out train
    experiments/thresholds.py train

One line of Markdown per method: its own threshold, the best one, and the square of the scenes' mean root of 1 - F at
both, over the training scenes of the run. This is what `inkbench tune --objective scenes` lowers: pooled pixels would
let one scene of many lines decide for all others. `gain` is the 95 % interval of the difference of the mean roots,
scenes resampled 2000 times. Shipped thresholds are found so; one stays as long as that interval holds 0. Exit code 2:
the folder is no such run.
"""

import numpy as np

from run_tables import BASELINES, print_heads, read, scored, words_of


def roots(lines):
    """The root of 1 - F of each scene."""
    sums = lines.groupby("scene")[["k", "n_pred", "n_truth"]].sum()
    error = 1 - 2 * sums.k / (sums.n_pred + sums.n_truth).clip(lower=1)
    return np.sqrt(error.clip(lower=0))


def gain_interval(own, best):
    """The 95 % interval of the mean of own - best, scenes resampled."""
    difference = (own - best).to_numpy()
    drawn = np.random.default_rng(0).integers(len(difference), size=(2000, len(difference)))
    return np.quantile(difference[drawn].mean(axis=1), [0.025, 0.975])


def main():
    rows, curves = read(*words_of(__doc__, most=1), "rows.csv", "curves.csv")
    rows = scored(rows, BASELINES)
    facts = rows[rows.split == "train"][["cell", "method", "scene", "threshold"]].rename(columns={"threshold": "own"})
    print_heads(["method"], ["own", "its error", "best", "its error", "gain"])
    for method, of in curves.merge(facts, on="cell").groupby("method"):
        by_threshold = of.groupby("threshold").apply(roots)
        # Line i of a curve is of an edge response of i percent of 255, rounded up.
        by_threshold.index = np.ceil(2.55 * by_threshold.index).astype(int)
        errors = by_threshold.mean(axis=1) ** 2
        own = int(of.own.iloc[0])
        nearest = errors.index[np.abs(errors.index - own).argmin()]
        best = errors.idxmin()
        low, high = gain_interval(by_threshold.loc[nearest], by_threshold.loc[best])
        print(f"| `{method}` | {own} | {errors[nearest]:.4f} | {best} | {errors[best]:.4f} | {low:+.4f} to {high:+.4f} |")


if __name__ == "__main__":
    main()
