"""What a millisecond buys: error against time, settings, sizes and threads."""

import matplotlib.pyplot as plt
import numpy as np

from paper import layout
from paper.chart import Chart, Nothing
from paper.methods import panels_by_family
from paper.runs import BASELINES, ONE_SAMPLE, answer_of, extent, ms, pooled
from paper.style import FAINT, INK, MIST, PAPER

_NO_TIMES = "the run was made without times (--no-times)"


def front(points):
    """The names of points that no other beats in both, fastest first.

    points: name -> (time, error).
    """
    best, names = float("inf"), []
    for name, (_, error) in sorted(points.items(), key=lambda item: item[1]):
        if error < best:
            names.append(name)
            best = error
    return names


def stacks(dots, reach):
    """How many earlier points lie nearer than `reach` to each point: 0 for one that stands alone.

    Rings of growing size show points that would hide each other.
    """
    return [sum(1 for other in dots[:i] if np.hypot(*(np.array(dot) - other)) < reach)
            for i, dot in enumerate(dots)]


def error_time(runs, style):
    """Every method at its own settings: error against time, intervals both ways, Pareto front."""
    summary = runs.summary()
    if not (summary["draw_ms"] > 0).any():
        raise Nothing(_NO_TIMES)
    methods = [m for m in style.by_family(summary.index) if summary.loc[m, "draw_ms"] > 0]
    lines = summary.loc[methods]
    for tall in (0.45, 0.6, 0.8, 1.0, 1.3, 1.7):
        figure, is_free = _error_time(style, summary, lines, max(2.4, tall * style.width_in))
        if is_free:
            break
        plt.close(figure)
    points = {m: (line["draw_ms"], 1 - line["f_2px"]) for m, line in lines.iterrows()}
    facts = answer_of(lines)[1] + ["from the fastest, each better than all before: " + "; ".join(
        f"{m} {ms(points[m][0])} ms, error {points[m][1]:.3f}" for m in front(points))]
    rows = runs.table_if_any("rows.csv")
    where = "" if rows is None else f"Over {extent(rows)}" + (
        f", {', '.join(rows['cpu'].dropna().unique())}. " if "cpu" in rows else ". ")
    outside = [m for m in methods if style.is_outside(m)]
    clocks = f"Times of {', '.join(outside)} are by their own clock. " if outside else ""
    return Chart(figure, "Error against time, each method at its own settings. Bars: quartiles of "
                 "the time over views, 95 % interval of the error. The grey stair is the Pareto "
                 "front: methods on it are beaten by none in both. Points that lie on each other are "
                 "rings of growing size. " + clocks + where + runs.source("summary.csv"), facts)


def _error_time(style, summary, lines, height_in):
    figure, axes = layout.new_figure(style, height_in)
    ax = axes[0, 0]
    ax.set_xscale("log")
    ax.set_yscale("log")
    times, errors = lines["draw_ms"], 1 - lines["f_2px"]
    # One view has no quartiles.
    low_t = np.minimum(lines["draw_ms_lo"].fillna(times), times).min()
    high_t = np.maximum(lines["draw_ms_hi"].fillna(times), times).max()
    error_lo = (1 - lines["f_hi"].fillna(lines["f_2px"])).clip(lower=1e-4)
    error_hi = (1 - lines["f_lo"].fillna(lines["f_2px"])).clip(lower=1e-4)
    one_sample = {name: 1 - summary.loc[name, "f_2px"] for name in ONE_SAMPLE
                  if name in summary.index and summary.loc[name, "f_2px"] < 1}
    low_e, high_e = min([error_lo.min(), *one_sample.values()]), error_hi.max()
    if high_t < 1.5 * low_t:  # one method, or all alike: an axis needs some length
        low_t, high_t = low_t / 1.5, high_t * 1.5
    if high_e < 1.5 * low_e:
        low_e, high_e = low_e / 1.5, high_e * 1.5
    ax.set_xlim(low_t / (high_t / low_t) ** 0.12, high_t * (high_t / low_t) ** 0.16)
    ax.set_ylim(low_e / (high_e / low_e) ** 0.07, high_e * (high_e / low_e) ** 0.07)
    layout.plain_ticks(ax)
    ax.set_xlabel("time of a frame, ms")
    ax.set_ylabel("error 1 − F at 2 px")
    points = {m: (times[m], errors[m]) for m in lines.index}
    best = front(points)
    ax.step([points[m][0] for m in best] + [ax.get_xlim()[1]],
            [points[m][1] for m in best] + [points[best[-1]][1]], where="post", color=MIST,
            linewidth=1.6 * style.scale, zorder=1)
    bars = []
    for m, line in lines.iterrows():
        tone = style.colour(m)
        for bar in (((line["draw_ms_lo"], errors[m]), (line["draw_ms_hi"], errors[m])),
                    ((times[m], error_lo[m]), (times[m], error_hi[m]))):
            if np.isfinite(bar).all():
                bars.append(bar)
                ax.plot(*zip(*bar), color=tone, linewidth=0.7 * style.scale, alpha=0.4, zorder=2)
    for name, error in one_sample.items():
        ax.axhline(error, color=FAINT, linestyle=ONE_SAMPLE[name][1], linewidth=1)
    entries = [(name, {"color": style.colour(members[0]), "marker": "o", "linestyle": ""})
               for name, members in style.families_of(lines.index).items()]
    entries.append(("Pareto front", {"color": MIST, "linewidth": 1.6 * style.scale}))
    for name in one_sample:
        label, dashes = ONE_SAMPLE[name]
        entries.append((label, {"color": FAINT, "linestyle": dashes, "linewidth": 1}))
    layout.key(figure, style, entries)
    figure.draw_without_rendering()
    dots = [ax.transData.transform(points[m]) for m in lines.index]
    depth = stacks(dots, 3.2 * style.scale)
    for m, n in zip(lines.index, depth):
        look = {**style.look(m), "linestyle": ""}
        if n:  # an open ring round what lies there already
            look |= {"markerfacecolor": "none", "marker": "o",
                     "markersize": (4 + 3.2 * n) * style.scale}
        ax.plot(*points[m], zorder=5 - 0.1 * n, **look)
    places = layout.LabelPlaces(ax, style, [(*points[m], m) for m in lines.index], bars)
    _, is_free = places.place()
    places.draw([style.text_colour(m) for m in lines.index])
    return figure, is_free


def settings(runs, style):
    """What the settings of each method trade between time and error."""
    sweep = runs.table("sweep.csv", "`inkbench compare` sweeps settings unless --no-sweep is given")
    if not sweep["draw_ns"].notna().any():
        raise Nothing(_NO_TIMES)
    points = pooled(sweep, ["method", "params"])
    times = sweep.groupby(["method", "params"], sort=False)["draw_ns"].median() / 1e6
    points = points.merge(times.rename("ms").reset_index()).sort_values(["ms", "error"])
    points["best_so_far"] = points.groupby("method")["error"].cummin()
    groups = style.families_of(points["method"])
    figure, axes = panels_by_family(style, groups, 2.1, sharex=True, sharey=True)
    ends = []
    for ax, members in zip(axes.flat, groups.values()):
        ax.step(points["ms"], points["error"].cummin(), where="post", color=MIST,
                linewidth=2.2 * style.scale, zorder=1)
        own_ends = []
        for method in members:
            own = points[points["method"] == method]
            look = style.look(method, True)
            ax.plot(own["ms"], own["error"], linestyle="", marker=look["marker"],
                    markersize=2.2 * style.scale, color=look["color"], alpha=0.45,
                    markeredgewidth=0)
            steps = own[own["error"] == own["best_so_far"]]
            ax.step(steps["ms"], steps["error"], where="post",
                    **{**look, "markersize": 3.2 * style.scale, "linewidth": 0.9 * style.scale})
            own_ends.append((steps["ms"].iloc[-1], steps["error"].iloc[-1], method))
        layout.log_axes(ax)
        ends.append((ax, own_ends))
    figure.supxlabel("time of a frame, ms")
    figure.supylabel("error 1 − F at 2 px")
    layout.label_ends(figure, style, ends)
    facts = []
    for method in style.by_family(points["method"]):
        own = points[points["method"] == method]
        facts.append(f"{method}: {len(own)} settings, {ms(own['ms'].min())} to "
                     f"{ms(own['ms'].max())} ms, error {own['error'].min():.3f} to "
                     f"{own['error'].max():.3f}")
    return Chart(figure, "What settings trade: small marks are all settings of a sweep, stairs those "
                 "that no other of the method beats, the grey stair those that none beats at all. "
                 + runs.source("sweep.csv"), facts)


def sizes(runs, style):
    """How time grows with the image, for each number of threads."""
    rows = runs.table("rows.csv")
    rows = rows[~rows["method"].isin(BASELINES) & rows["draw_ns"].notna()]
    rows = rows.assign(megapixels=rows["width"] * rows["height"] / 1e6)
    counts = sorted(rows["threads"].unique())
    if rows["megapixels"].nunique() < 2 and len(counts) < 2:
        raise Nothing("the run has one size and one number of threads; "
                      "`inkbench run experiments/speed.toml` has several")
    times = rows.groupby(["method", "threads", "megapixels"])["draw_ns"].median() / 1e6
    groups = style.families_of(rows["method"])
    figure, axes = panels_by_family(style, groups, 2.0, sharey=True, sharex=True)
    dashes = ["-", "--", ":", "-."]
    ends = []
    for ax, members in zip(axes.flat, groups.values()):
        own_ends = []
        for method in members:
            for threads, dash in zip(counts, dashes):
                if (method, threads) not in times.index.droplevel(2):
                    continue
                points = times[method][threads]
                look = style.look(method, True)
                is_first = threads == counts[0]
                ax.plot(points.index, points.values, **{
                    **look, "linestyle": dash, "markersize": 3 * style.scale,
                    "markerfacecolor": look["markerfacecolor"] if is_first else PAPER})
                if is_first:
                    own_ends.append((points.index[-1], points.values[-1], method))
        layout.log_axes(ax)
        ends.append((ax, own_ends))
    figure.supxlabel("megapixels")
    figure.supylabel("time of a frame, ms")
    facts = []
    if len(counts) > 1:
        layout.key(figure, style, [
            (f"{threads} thread{'s' if threads > 1 else ''}", {"color": INK, "linestyle": dash})
            for threads, dash in zip(counts, dashes)])
        wide = times.unstack("threads")
        gain = (wide[counts[0]] / wide[counts[-1]]).groupby("method").median().sort_values()
        facts.append(f"{counts[-1]} threads against {counts[0]}: {gain.iloc[0]:.2f} x as fast "
                     f"({gain.index[0]}) to {gain.iloc[-1]:.2f} x ({gain.index[-1]}), median of "
                     "sizes")
    layout.label_ends(figure, style, ends)
    return Chart(figure, "Median time of a frame over the size of the image and the number of "
                 "threads, by family. " + runs.source("rows.csv"), facts)
