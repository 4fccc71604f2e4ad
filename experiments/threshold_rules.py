#!/usr/bin/python3
"""Prints what a threshold chosen from the image alone would gain, for every method of a run.

    experiments/threshold_rules.py RUN [RUN...]

Reads rows.csv and curves.csv of run folders of `inkbench compare`. The rule: the lowest threshold T from which
on thinned line pixels hardly become fewer, ln(n(T) / n(2 T)) / ln 2 <= limit. One line of Markdown per method
and limit, and one for a rule that knows the truth (the best threshold of each image): the difference in pooled
F at 2 px to the method's own threshold, on each part of the suite that the runs have. Exit code 2: a folder is no such run.
"""

import numpy as np
import pandas as pd

from run_tables import BASELINES, pooled_f, print_heads, read, scored, words_of

COUNTS = ["k", "n_pred", "n_truth"]
LIMITS = (0.05, 0.1, 0.15, 0.2, 0.3, 0.4)


def read_curves(folder):
    """All lines of curves.csv with method, part and own threshold of their cells."""
    rows, curves = read(folder, "rows.csv", "curves.csv")
    facts = scored(rows, BASELINES)[["cell", "method", "split", "threshold"]].rename(columns={"threshold": "own"})
    return curves.merge(facts, on="cell").assign(run=str(folder))


def own_line(curve):
    """The line of the threshold nearest to the method's own."""
    return int(np.argmin(np.abs(np.ceil(2.55 * curve.threshold) - curve.own)))


def level_line(curve, limit):
    """The line of the lowest threshold from which on pixels hardly become fewer."""
    count = np.log(np.maximum(curve.n_pred.to_numpy(), 1))
    thresholds = curve.threshold.to_numpy()
    doubled = np.searchsorted(thresholds, 2 * thresholds)
    for i, j in enumerate(doubled):
        if j == len(thresholds):
            return max(i - 1, 0)
        if count[i] - count[j] <= limit * np.log(2):
            return i
    return len(thresholds) - 1


def best_line(curve):
    """The line with the highest F: what no rule that sees the image alone can know."""
    f = 2 * curve.k / np.maximum(curve.n_pred + curve.n_truth, 1)
    return int(np.argmax(f.to_numpy()))


def table(curves):
    """Markdown, without its heading."""
    rules = {f"limit {limit:g}": lambda curve, limit=limit: level_line(curve, limit) for limit in LIMITS}
    rules["best of each image"] = best_line
    parts = [part for part in ("train", "heldout", "real") if part in set(curves.split)]
    print_heads(["method", "rule"], parts)
    for method, of_method in curves.groupby("method"):
        cells = [curve.sort_values("threshold") for _, curve in of_method.groupby(["run", "cell"])]
        own = [curve.iloc[own_line(curve)] for curve in cells]
        for name, rule in rules.items():
            picked = [curve.iloc[rule(curve)] for curve in cells]
            gains = []
            for part in parts:
                here, there = (pooled_f(pd.DataFrame([line for line in lines if line.split == part])[COUNTS].sum(), "k")
                               for lines in (picked, own))
                gains.append(f"{here - there:+.3f}")
            print(f"| `{method}` | {name} | " + " | ".join(gains) + " |")


def main():
    table(pd.concat([read_curves(folder) for folder in words_of(__doc__)], ignore_index=True))


if __name__ == "__main__":
    main()
