#!/usr/bin/python3
"""Prints the tables of one_byte.md from runs of experiments/one_byte.toml.

    experiments/one_byte.py RUN [RUN...]

Markdown, F at 2 px of all views pooled, for each part of the suite that the runs have: methods with bytes and the
median time of a frame, then settings of methods that were swept. `least` is the least F of a scene or model of the
part `real`. Crowded views do not count. Exit code 2: a folder is no such run.
"""

from pathlib import Path

import pandas as pd

from run_tables import pooled_f, print_heads, read, scored, words_of

PARTS = ("train", "heldout", "real")
COUNTS = ["k_2px", "n_pred", "n_truth"]


def read_run(folder):
    """The scored rows of a run folder, and its sweep with what the rows say of each cell."""
    has_sweep = (Path(folder) / "sweep.csv").exists()
    rows, *swept = read(folder, *["rows.csv", "sweep.csv"][:1 + has_sweep], by="run")
    sweep = swept[0] if swept else pd.DataFrame(columns=["cell", "status"])
    rows = scored(rows)
    facts = rows[["cell", "method", "scene", "split"]]
    return rows, sweep[sweep.status == "ok"].merge(facts, on="cell")


def scores(lines, parts):
    """F by part, and the least of a real model."""
    texts = [f"{pooled_f(lines[lines.split == part][COUNTS].sum()):.4f}" for part in parts]
    if "real" in parts:
        real = lines[lines.split == "real"]
        least = min((pooled_f(of[COUNTS].sum()), scene) for scene, of in real.groupby("scene"))
        texts.append(f"{least[0]:.3f} ({least[1]})")
    return " | ".join(texts)


def print_table(heads, lines):
    """A table in Markdown; `lines` are pairs of its first cells and of the lines to score."""
    parts = [part for part in PARTS if any(part in set(scored.split) for _, scored in lines)]
    columns = list(parts) + (["least"] if "real" in parts else [])
    print_heads(heads, columns)
    for cells, scored in lines:
        print(f"| {' | '.join(cells)} | {scores(scored, parts)} |")
    print()


def main():
    runs = [read_run(folder) for folder in words_of(__doc__)]
    rows, sweep = (pd.concat(tables, ignore_index=True) for tables in zip(*runs))

    def of_method(method, of):
        time = f"{of.draw_ns.median() / 1e6:.2f}" if of.draw_ns.notna().any() else "-"
        size = f"{of.bytes_per_px.iloc[0]:.0f}" if of.bytes_per_px.notna().any() else "-"
        return [f"`{method}`", size, time], of

    print_table(["method", "B/px", "ms"],
                [of_method(*group) for group in rows.groupby("method", sort=False)])
    for method, of in sweep.groupby("method", sort=False):
        swept = [name for name in sweep.columns
                 if of[name].notna().any() and of[name].nunique() > 1 and is_parameter(name, sweep)]
        # A whole number that some lines lack is read as a float.
        settings = of[swept].astype(str).replace(r"\.0$", "", regex=True).agg(", ".join, axis=1)
        print_table([f"`{method}`: {', '.join(swept)}", "ms"],
                    [([setting, f"{group.draw_ns.median() / 1e6:.2f}"], group)
                     for setting, group in of.groupby(settings, sort=False)])


def is_parameter(name, sweep):
    """Whether a column of sweep.csv is a parameter: those stand between `status` and `f_2px`."""
    columns = list(sweep.columns)
    return columns.index("status") < columns.index(name) < columns.index("f_2px")


if __name__ == "__main__":
    main()
