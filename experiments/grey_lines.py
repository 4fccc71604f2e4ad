"""The table of grey_lines.md, in Markdown, from what experiments/grey.toml wrote.

    grey_lines.py [FOLDER]     default: inkbench-out/grey
"""

import sys

import pandas as pd

from run_tables import BASELINES, pooled_f, print_heads, read, refuse, scored, words_of

INK = ["ink_matched_px", "ink_misplaced_px", "ink_surplus_px", "ink_missing_px"]
COUNTS = ["k_2px", "n_pred", "n_truth"]
KINDS = ["", "_resolve4", "_resolve16"]


def soft_f(ink):
    """Soft F of summed ink."""
    drawn = ink.ink_matched_px + ink.ink_misplaced_px + ink.ink_surplus_px
    true = ink.ink_matched_px + ink.ink_misplaced_px + ink.ink_missing_px
    return 2 * ink.ink_matched_px / (drawn + true)


def main():
    words = words_of(__doc__, least=0, most=1)
    folder = words[0] if words else "inkbench-out/grey"
    rows = scored(read(folder, "rows.csv", by="run experiments/grey.toml")[0], without=("none",))
    if "soft_f" not in rows or rows.soft_f.isna().all():
        refuse(f"{folder}: its rows have no soft_f (accepted: a run with --coverage)")
    sums = rows.groupby("method")[INK + COUNTS].sum()
    true = sums.ink_matched_px + sums.ink_misplaced_px + sums.ink_missing_px
    ms = rows.groupby("method").draw_ns_min.median() / 1e6
    soft = soft_f(sums)
    names = [name for name in sums.index if not name.endswith(("_resolve4", "_resolve16"))]
    names.sort(key=lambda name: -soft[name + KINDS[2] if name + KINDS[2] in soft else name])
    heads = ["F", "soft F", "soft F of 4", "soft F of 16", "misplaced", "surplus", "missing", "ms", "ms of 4", "ms of 16"]
    print_heads(["method"], heads)
    for name in names:
        own = [name + kind if name + kind in sums.index else None for kind in KINDS]
        cells = [f"{pooled_f(sums.loc[name]):.3f}"]
        cells += ["" if of is None else f"{soft[of]:.3f}" for of in own]
        last = own[2] or own[1] or own[0]
        cells += [f"{sums.loc[last, what] / true[last]:.3f}"
                  for what in ("ink_misplaced_px", "ink_surplus_px", "ink_missing_px")]
        cells += ["" if of is None or name in BASELINES else f"{ms[of]:.1f}" for of in own]
        print(f"| `{name}` | {' | '.join(cells)} |")
    drawn = [name for name in names if name not in BASELINES]
    f = pd.Series({name: pooled_f(sums.loc[name]) for name in drawn})
    for kind in KINDS:
        of = pd.Series({name: soft[name + kind] for name in drawn if name + kind in sums.index})
        if len(of) == len(f):
            print(f"\nRank correlation of F and soft F{kind and ' of '}{kind[len('_resolve'):]}: {f.corr(of, 'spearman'):.2f}")


if __name__ == "__main__":
    sys.exit(main())
