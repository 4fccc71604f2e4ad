"""Recall by class of line, and how a table of methods is drawn."""

import pandas as pd

from paper import layout
from paper.chart import Chart, Nothing
from paper.runs import RECALL_GROUPS, extent
from paper.sheet import GRID_DPI, text_width_px
from paper.style import FAINT


def _cells(ax, table, style, is_dark, digits):
    """Writes the numbers of a heat map; dashes where there are none."""
    for i in range(table.shape[0]):
        for j in range(table.shape[1]):
            value = table.iloc[i, j]
            text = "–" if pd.isna(value) else f"{value:.{digits}f}"
            ax.text(j, i, text, ha="center", va="center", fontsize=style.small_pt,
                    color=FAINT if pd.isna(value) else "white" if is_dark(value) else "black")


def _height_in(style, count, extra_lines, label):
    """Height of so many rows with other lines below, and a colour bar whose label stands upright."""
    return max(layout.rows_height_in(style, count, extra_lines),
               text_width_px(label, style.font_pt) / GRID_DPI
               + layout.line_height_in(style, extra_lines))


def heat_map(style, table, label, digits=3, is_loss=False):
    """A figure of a table with a row a method; numbers where they have room.

    The scale begins where the data is; dark is low, or high if `is_loss`.
    """
    count = table.shape[1]
    cell_in = (style.width_in - 18 * style.font_pt / 72) / max(1, count)
    has_numbers = cell_in > (digits + 2) * 0.55 * style.small_pt / 72
    is_turned = cell_in < 1.1 / GRID_DPI * max(
        (text_width_px(str(name), style.small_pt) for name in table.columns), default=0)
    figure, axes = layout.new_figure(
        style, _height_in(style, len(table), 8 if is_turned else 4, label))
    ax = axes[0, 0]
    low, high = table.min().min(), table.max().max()
    shown = ax.imshow(table, cmap="cividis_r" if is_loss else "cividis", vmin=low, vmax=high,
                      aspect="auto")
    if has_numbers:
        middle = (low + high) / 2
        _cells(ax, table, style, lambda v: v > middle if is_loss else v < middle, digits)
    layout.method_axis(ax, style, list(table.index))
    for line in list(ax.lines):
        line.remove()
    ax.set_ylim(len(table) - 0.5, -0.5)
    if is_turned:
        ax.set_xticks(range(count), table.columns, rotation=50, ha="right",
                      rotation_mode="anchor")
    else:
        ax.set_xticks(range(count), table.columns)
    ax.tick_params(length=0)
    ax.grid(visible=False)
    bar = figure.colorbar(shown, ax=ax, label=label, fraction=0.04, pad=0.015)
    bar.outline.set_visible(False)
    return figure


def classes(runs, style):
    """Recall of each method on each class of line that the scenes have."""
    rows = runs.table_of_methods("rows.csv")
    methods = style.by_family(rows["method"])
    if not methods:
        raise Nothing("the run has no method beside the baselines")
    counts = rows.groupby("method")[[f"{kind}_{name}" for kind in ("k", "truth_px")
                                     for name in RECALL_GROUPS]].sum()
    there = [name for name in RECALL_GROUPS if counts[f"truth_px_{name}"].sum() > 0]
    if not there:
        raise Nothing("the run counted no lines by class (full_scores = false)")
    recalls = pd.DataFrame({RECALL_GROUPS[name]: counts[f"k_{name}"] / counts[f"truth_px_{name}"]
                            for name in there}).loc[methods]
    figure = heat_map(style, recalls, "recall at 2 px")
    absent = [title for name, title in RECALL_GROUPS.items() if name not in there]
    facts = [f"{name}: {recalls[name].idxmax()} {recalls[name].max():.3f} at best, "
             f"{recalls[name].idxmin()} {recalls[name].min():.3f} at worst" for name in recalls]
    caption = (f"Recall at 2 px by class of line, views pooled. Over {extent(rows)}. "
               + (f"Classes that these scenes do not have are left out: {', '.join(absent)}. "
                  if absent else "") + runs.source("rows.csv"))
    return Chart(figure, caption, facts)


