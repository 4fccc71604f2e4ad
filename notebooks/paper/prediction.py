"""Misses of linear codes: as predicted from truth and weights alone, and as measured."""

import numpy as np

from paper import layout
from paper.chart import Chart, Nothing
from paper.runs import CLASSES
from paper.style import BLUE, CLASS_COLOURS, FAINT, MIST, PAPER

_COLUMNS = ["n_truth", "predicted_missed", "measured_missed"]
_LEAST_PX = 50


def _frame(runs):
    return runs.table("cancellation.csv", "no method of the run declares a linear code, or the run "
                      "asked for brief scores")


def misses(runs, style):
    """A mark a class and method: predicted against measured share of missed pixels."""
    frame = _frame(runs)
    sums = frame.groupby(["method", "class"], sort=False)[_COLUMNS].sum().reset_index()
    sums = sums[sums["n_truth"] >= _LEAST_PX]
    for kind in ("predicted", "measured"):
        sums[kind] = 100 * sums[f"{kind}_missed"] / sums["n_truth"]
    methods = style.by_family(frame["method"])
    figure, axes = layout.new_figure(style, min(style.width_in, 4.2))
    ax = axes[0, 0]
    limit = max(1, 1.08 * sums[["predicted", "measured"]].max().max())
    along = np.arange(0, limit + 1, 0.25)
    ax.fill_between(along, along - 2, along + 2, color=MIST, alpha=0.5, linewidth=0)
    for scale in (ax.set_xscale, ax.set_yscale):
        scale("symlog", linthresh=5)
    ticks = [t for t in (0, 2, 5, 10, 20, 50, 100) if t < limit]
    ax.set_xticks(ticks, ticks)
    ax.set_yticks(ticks, ticks)
    ax.minorticks_off()
    for _, line in sums.iterrows():
        look = style.look(line["method"])
        tone = CLASS_COLOURS.get(line["class"], FAINT)
        ax.plot(line["predicted"], line["measured"], linestyle="", marker=look["marker"],
                color=tone, alpha=0.85, markerfacecolor="none"
                if style.base(line["method"]) != line["method"] else tone)
    ax.set_xlim(0, limit)
    ax.set_ylim(0, limit)
    ax.set_aspect("equal")
    ax.set_xlabel("predicted misses, % of the class")
    ax.set_ylabel("measured misses, % of the class")
    there = [c for c in CLASSES if c in set(sums["class"])]
    layout.key(figure, style, [
        (c, {"color": CLASS_COLOURS[c], "marker": "o", "linestyle": ""}) for c in there] + [
        (m, {"color": FAINT, "linestyle": "", "marker": style.look(m)["marker"],
             "markerfacecolor": FAINT if style.base(m) == m else PAPER}) for m in methods] + [
        ("within 2 points", {"patch": {"color": MIST, "alpha": 0.5}})])
    facts = [f"{line['method']}, creases: {line['predicted']:.1f} % predicted, "
             f"{line['measured']:.1f} % measured, {line['measured'] - line['predicted']:+.1f} points"
             for _, line in sums[sums["class"] == "crease"].iterrows()]
    return Chart(figure, "Missed pixels of each class of line and method with a linear code: "
                 "predicted from the truth's geometry and the weights alone, and measured. Both "
                 "scales are linear up to 5 %. " + runs.source("cancellation.csv"), facts)


def misses_by_angle(runs, style):
    """Missed creases over the dihedral: measured as a line, predicted as an area."""
    frame = _frame(runs)
    creases = frame[frame["class"] == "crease"]
    bent = creases.groupby(["method", "dihedral_low_deg"])[_COLUMNS].sum().reset_index()
    bent = bent[bent["n_truth"] >= _LEAST_PX]
    if not len(bent):
        raise Nothing(f"no angle between faces has {_LEAST_PX} true pixels of creases")
    methods = style.by_family(bent["method"])
    rows, columns = layout.grid_of(len(methods), style.columns(34, 5))
    figure, axes = layout.new_figure(style, 1.2 * rows, rows, columns, sharex=True, sharey=True)
    facts = []
    for ax, method in zip(axes.flat, methods):
        own = bent[bent["method"] == method]
        angle = (own["dihedral_low_deg"] + 5).values
        predicted = (100 * own["predicted_missed"] / own["n_truth"]).values
        measured = (100 * own["measured_missed"] / own["n_truth"]).values
        ax.fill_between(angle, 0, predicted, color=MIST, linewidth=0)
        ax.plot(angle, measured, color=BLUE, marker="o", markersize=2 * style.scale,
                linewidth=0.9 * style.scale)
        ax.set_title(method, color=style.text_colour(method), fontsize=style.small_pt)
        ax.set_xlim(0, 180)
        ax.set_xticks([0, 90, 180])
        ax.set_ylim(bottom=0)
        gap = (np.abs(measured - predicted) * own["n_truth"]).sum() / own["n_truth"].sum()
        facts.append(f"{method}: {gap:.2f} points between measured and predicted, the mean over "
                     "pixels")
    layout.hide_rest(axes, len(methods))
    figure.supylabel("creases missed, %")
    figure.supxlabel("dihedral, degrees from flat")
    layout.key(figure, style, [("measured", {"color": BLUE, "marker": "o", "markersize": 2}),
                               ("predicted", {"patch": {"color": MIST}})])
    return Chart(figure, "Creases missed over the angle between their faces, in bins of 10 degrees "
                 f"with {_LEAST_PX} true pixels or more: measured, and predicted from the weights "
                 "alone. " + runs.source("cancellation.csv"), facts)
