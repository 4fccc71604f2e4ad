"""What a millisecond buys: error against time."""

import matplotlib.pyplot as plt
import numpy as np

from paper import layout
from paper.chart import Chart, Nothing
from paper.runs import ONE_SAMPLE, Judged, answer_of, extent, ms
from paper.style import FAINT, MIST


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
        raise Nothing("the run was made without times (--no-times)")
    methods = [m for m in style.by_family(summary.index) if summary.loc[m, "draw_ms"] > 0]
    lines = summary.loc[methods]
    for tall in (0.45, 0.6, 0.8, 1.0, 1.3, 1.7):
        figure, is_free = _error_time(style, summary, lines, max(2.4, tall * style.width_in))
        if is_free:
            break
        plt.close(figure)
    by = Judged(lines)
    points = {m: (line["draw_ms"], 1 - line[by.f]) for m, line in lines.iterrows()}
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
    by = Judged(lines)
    times, errors = lines["draw_ms"], 1 - lines[by.f]
    # One view has no quartiles.
    low_t = np.minimum(lines["draw_ms_lo"].fillna(times), times).min()
    high_t = np.maximum(lines["draw_ms_hi"].fillna(times), times).max()
    error_lo = (1 - lines[by.high].fillna(lines[by.f])).clip(lower=1e-4)
    error_hi = (1 - lines[by.low].fillna(lines[by.f])).clip(lower=1e-4)
    one_sample = {name: 1 - summary.loc[name, by.f] for name in ONE_SAMPLE
                  if name in summary.index and summary.loc[name, by.f] < 1}
    low_e, high_e = min([error_lo.min(), *one_sample.values()]), error_hi.max()
    if high_t < 1.5 * low_t:  # one method, or all alike: an axis needs some length
        low_t, high_t = low_t / 1.5, high_t * 1.5
    if high_e < 1.5 * low_e:
        low_e, high_e = low_e / 1.5, high_e * 1.5
    ax.set_xlim(low_t / (high_t / low_t) ** 0.12, high_t * (high_t / low_t) ** 0.16)
    ax.set_ylim(low_e / (high_e / low_e) ** 0.07, high_e * (high_e / low_e) ** 0.07)
    layout.plain_ticks(ax)
    ax.set_xlabel("time of a frame, ms")
    ax.set_ylabel(f"error 1 − {by.title}")
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
