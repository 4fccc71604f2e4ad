"""One difficulty at a time: how much each method loses along an axis."""

import matplotlib.pyplot as plt
import numpy as np

from paper import layout
from paper.chart import Chart, Nothing
from paper.methods import heat_map
from paper.runs import BASELINES, ONE_SAMPLE, counted
from paper.style import INK, MIST

FLAT = 0.005      # an axis along which no method loses more is named, not drawn
_NAMED = 3        # lines a panel that have a name


def _frame(runs):
    stress = runs.table("axis_summary.csv", "`inkbench stress` writes it")
    units = runs.table("axes.csv").set_index("axis")["unit"]
    stress["unit"] = stress["axis"].map(units)
    one_sample = stress[stress["method"].isin(ONE_SAMPLE)]
    stress = stress[~stress["method"].isin(BASELINES)]
    if not len(stress):
        raise Nothing("the run has no method beside the baselines")
    return stress.fillna({"unit": ""}), one_sample


def _losses(stress, style):
    loss = stress.groupby(["method", "axis"])["f"].agg(lambda f: f.max() - f.min())
    loss = loss.unstack("axis")
    return loss.loc[style.by_family(loss.index), list(dict.fromkeys(stress["axis"]))]


def _faults(stress):
    lines = []
    for column in ("non_finite", "overflow", "lost_cells", "differing"):
        where = stress[stress[column] > 0]
        names = ", ".join(sorted(where["axis"].unique()))
        lines.append(f"{column}: {int(stress[column].sum())}" + (f" ({names})" if names else ""))
    return lines


def _scale(ax, values):
    values = np.sort(values.unique())
    if values[0] > 0 and values[-1] / values[0] > 50:
        ax.set_xscale("log")
        ax.xaxis.set_major_locator(plt.LogLocator(numticks=5))
        ax.xaxis.set_minor_locator(plt.NullLocator())
    elif len(values) <= 12 and (values == values.astype(int)).all() and values[-1] < 13:
        ax.set_xticks(values.astype(int))


def _words(name, units):
    return name.replace("_", " ") + (f", {units[name]}" if units[name] else "")


def curves(runs, style):
    """F along each axis on which some method loses; the three that lose most have their names."""
    stress, one_sample = _frame(runs)
    loss = _losses(stress, style)
    shown = [name for name in loss if loss[name].max() > FLAT]
    flat = [name for name in loss if name not in shown]
    if not shown:
        raise Nothing("no method loses more than 0.005 along any axis")
    units = stress.groupby("axis")["unit"].first()
    few = len(loss) <= 6
    rows, columns = layout.grid_of(len(shown), style.columns(54, 3))
    figure, axes = layout.new_figure(style, 1.45 * rows, rows, columns)
    ends = []
    for ax, name in zip(axes.flat, shown):
        along = stress[stress["axis"] == name].sort_values("value")
        named = list(loss.index if few else loss[name].nlargest(_NAMED).index)
        own_ends = []
        for method in loss.index:
            own = along[along["method"] == method]
            if not len(own):
                continue
            if method not in named:
                ax.plot(own["value"], own["f"], color=MIST, linewidth=0.7 * style.scale, zorder=1)
                continue
            look = style.look(method, True)
            if own["f_lo"].notna().any():
                ax.fill_between(own["value"], own["f_lo"], own["f_hi"], color=look["color"],
                                alpha=0.1, linewidth=0)
            ax.plot(own["value"], own["f"], **{**look, "markersize": 2.4 * style.scale,
                                               "linewidth": 0.9 * style.scale})
            own_ends.append((own["value"].iloc[-1], own["f"].iloc[-1], method))
        for method, most in one_sample[one_sample["axis"] == name].groupby("method"):
            most = most.sort_values("value")
            ax.plot(most["value"], most["f"], color=INK, linestyle=ONE_SAMPLE[method][1],
                    linewidth=1, zorder=1.5)
        _scale(ax, along["value"])
        low = along["f"].min()
        ax.set_ylim(max(0, low - 0.05) if low > 0.5 else 0, 1.02)
        ax.set_xlabel(_words(name, units))
        if not few:
            ends.append((ax, own_ends))
    layout.hide_rest(axes, len(shown))
    figure.supylabel("F at 2 px")
    entries = [(m, {**style.look(m, True), "markersize": 3 * style.scale})
               for m in loss.index] if few else [("another method", {"color": MIST})]
    layout.key(figure, style, entries + [
        (label, {"color": INK, "linestyle": dashes}) for label, dashes in ONE_SAMPLE.values()])
    layout.label_ends(figure, style, ends)
    facts = _faults(stress)
    if flat:
        facts.insert(0, f"no method loses more than {FLAT} along " + ", ".join(
            name.replace("_", " ") for name in flat))
    return Chart(figure, f"F at 2 px of {counted(len(loss), 'method')} along "
                 f"{counted(len(shown), 'axis').replace('axiss', 'axes')} of difficulty"
                 + ("" if few else "; named are the three that lose most")
                 + ". Shades: 95 % intervals (cases resampled). Axes on which no method loses are "
                 "left out. " + runs.source("axis_summary.csv"), facts)


def losses(runs, style):
    """The most that each method loses on each axis."""
    stress, _ = _frame(runs)
    loss = _losses(stress, style)
    loss.columns = [name.replace("_", " ") for name in loss]
    figure = heat_map(style, loss, "F at its best less F at its worst", digits=2, is_loss=True)
    facts = [f"{name}: {loss[name].idxmin()} loses {loss[name].min():.3f}, {loss[name].idxmax()} "
             f"{loss[name].max():.3f}" for name in loss] + _faults(stress)
    return Chart(figure, "What each method loses along each axis of difficulty: F where it is best "
                 "less F where it is worst. " + runs.source("axis_summary.csv"), facts)
