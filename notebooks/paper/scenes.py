"""What is drawn, and what is true of it: lines by class, what contours stand before, trust."""

from paper import layout
from paper.chart import Chart, Nothing
from paper.methods import class_key
from paper.runs import CLASSES, extent, views_of
from paper.style import BLUE, CLASS_COLOURS, FAINT, INK, MISSING

_BEHIND = {"contour_sky_px": ("before the sky", "#009bcf"),
           "contour_other_px": ("before another object", "#bf7800"),
           "contour_self_px": ("before their own object", INK)}
# The parts of a suite in their order, and what texts call them.
SPLITS = ["train", "heldout", "real"]
SPLIT_NAMES = {"train": "training scenes", "heldout": "held-out scenes", "real": "real models"}
_MOST_DISAGREEMENT = 0.1  # %: views beyond have no score


def _views(runs):
    """One row a view at the largest size; scenes by part; their splits."""
    rows = runs.table("rows.csv")
    views = views_of(rows)
    views = views[views["width"] == views["width"].max()]
    splits = views.groupby("scene", sort=False)["split"].first()
    scenes = list(splits.sort_values(key=lambda part: part.map(SPLITS.index), kind="stable").index)
    return views, scenes, splits


def _scene_axis(ax, style, scenes, splits):
    layout.name_axis(ax, style, scenes)
    for i in range(1, len(scenes)):
        if splits[scenes[i]] != splits[scenes[i - 1]]:
            ax.axhline(i - 0.5, color=FAINT, linewidth=0.8)


def _split_note(splits):
    names = [SPLIT_NAMES[split] for split in SPLITS if (splits == split).any()]
    return f"From the top, between rules: {', '.join(names)}. " if len(names) > 1 else ""


def classes(runs, style):
    """True pixels of each class and triangles, by scene."""
    views, scenes, splits = _views(runs)
    columns = [f"truth_px_{name}" for name in CLASSES]
    per_view = views.groupby("scene")[columns].mean().loc[scenes].fillna(0)
    figure, axes = layout.new_figure(style, layout.rows_height_in(style, len(scenes)), 1, 2,
                                     gridspec_kw={"width_ratios": [3, 1]}, sharey=True)
    left, right = axes[0]
    start = per_view[columns[0]] * 0
    for name, column in zip(CLASSES, columns):
        left.barh(range(len(scenes)), per_view[column], left=start, height=0.72,
                  color=CLASS_COLOURS[name], linewidth=0)
        start = start + per_view[column]
    left.set_xlabel("true pixels a view (mean)")
    right.plot(views.groupby("scene")["triangles"].max().loc[scenes], range(len(scenes)), "o",
               color=INK, markersize=3 * style.scale)
    right.set_xscale("log")
    right.minorticks_off()
    right.set_xlabel("triangles")
    for ax in (left, right):
        _scene_axis(ax, style, scenes, splits)
    layout.key(figure, style, class_key())
    totals = views[columns].sum()
    facts = ["; ".join(f"{name} {totals[column] / totals.sum():.1%}"
                       for name, column in zip(CLASSES, columns)) + " of all true pixels"]
    return Chart(figure, "True pixels of each class of line, and triangles, by scene. "
                 + _split_note(splits) + f"Over {extent(views)}. " + runs.source("rows.csv"), facts)


def contours(runs, style):
    """What visible contours stand before, by scene."""
    views, scenes, splits = _views(runs)
    lengths = views.groupby("scene")[list(_BEHIND)].sum().loc[scenes]
    total = lengths.sum(axis=1)
    if not total.sum() > 0:
        raise Nothing("the scenes show no contours, or the run did not measure what is behind them")
    shares = lengths.div(total.where(total > 0), axis=0).fillna(0)
    figure, axes = layout.new_figure(style, layout.rows_height_in(style, len(scenes)))
    ax = axes[0, 0]
    start = shares["contour_sky_px"] * 0
    for column, (_, tone) in _BEHIND.items():
        ax.barh(range(len(scenes)), 100 * shares[column], left=100 * start, height=0.72, color=tone,
                linewidth=0)
        start = start + shares[column]
    ax.set_xlim(0, 100)
    ax.set_xlabel("share of the length of visible contours, %")
    _scene_axis(ax, style, scenes, splits)
    layout.key(figure, style, [(label, {"patch": {"color": tone, "linewidth": 0}})
                               for label, tone in _BEHIND.values()])
    facts = ["; ".join(f"{label} {lengths[column].sum() / total.sum():.1%}"
                       for column, (label, _) in _BEHIND.items()) + " of all contours' length"]
    return Chart(figure, "What visible contours stand before, by scene. " + _split_note(splits)
                 + runs.source("rows.csv"), facts)


def trust(runs, style):
    """How crowded lines are, and how far truth and cross-check agree; a ring is a view."""
    views, scenes, splits = _views(runs)
    measured = [c for c in ("crowded_share", "reference_disagreement") if views[c].notna().any()]
    if not measured:
        raise Nothing("the run measured neither crowding nor the cross-check")
    titles = {"crowded_share": "true pixels too dense to score, %",
              "reference_disagreement": "lines that only one has, %"}
    figure, axes = layout.new_figure(style, layout.rows_height_in(style, len(scenes)), 1,
                                     len(measured), sharey=True)
    place = {scene: i for i, scene in enumerate(scenes)}
    facts = []
    for ax, column in zip(axes[0], measured):
        known = views.dropna(subset=[column])
        ax.plot(100 * known[column], known["scene"].map(place), "o", color=BLUE,
                markerfacecolor="none", markersize=3.5 * style.scale, clip_on=False)
        ax.set_xscale("symlog", linthresh=0.01 if column == "crowded_share" else 0.0001)
        ax.set_xlim(left=0)
        ax.minorticks_off()
        ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        ax.set_xlabel(titles[column])
        _scene_axis(ax, style, scenes, splits)
        worst = known.loc[known[column].idxmax()]
        facts.append(f"{column}: median {known[column].median():.3%}, at most {worst[column]:.3%} "
                     f"({worst['scene']}, {worst['view']}), 0 on {(known[column] == 0).sum()} of "
                     f"{len(known)} views")
    if "reference_disagreement" in measured:
        axes[0, -1].axvline(_MOST_DISAGREEMENT, color=MISSING, linewidth=0.8, linestyle="--")
        layout.key(figure, style, [("a view", {"color": BLUE, "marker": "o", "linestyle": "",
                                               "markerfacecolor": "none"}),
                                   ("not scored beyond", {"color": MISSING, "linestyle": "--"})])
    return Chart(figure, "True pixels that are too dense to be scored, and lines that only the truth "
                 "or only its cross-check has. A ring is a view. " + _split_note(splits)
                 + runs.source("rows.csv"), facts)
