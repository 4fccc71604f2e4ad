"""How good methods are: F with intervals, recall by class, causes of errors, tolerances."""

import pandas as pd

from paper import layout
from paper.chart import Chart, Nothing
from paper.runs import CLASSES, ONE_SAMPLE, RECALL_GROUPS, answer_of, counted, extent, pooled
from paper.sheet import GRID_DPI, text_width_px
from paper.style import CLASS_COLOURS, FAINT, FALSE_CAUSES, INK, MISSING_CAUSES, MIST


def f_by_method(runs, style):
    """F at 2 px with its interval, and on training scenes, held-out ones and real models."""
    summary = runs.summary()
    methods = style.by_family(summary.index)
    figure, axes = layout.new_figure(style, layout.rows_height_in(style, len(methods)))
    ax = axes[0, 0]
    for i, method in enumerate(methods):
        line = summary.loc[method]
        ax.plot([line["f_lo"], line["f_hi"]], [i, i], color=style.colour(method), linewidth=2.6,
                alpha=0.35, solid_capstyle="butt")
        ax.plot(line["f_train"], i - 0.24, "|", color=FAINT, markersize=4 * style.scale)
        ax.plot(line["f_heldout"], i + 0.24, "x", color=INK, markersize=3 * style.scale,
                markeredgewidth=0.8)
        if "f_real" in line:
            ax.plot(line["f_real"], i + 0.24, "+", color=INK, markersize=4 * style.scale,
                    markeredgewidth=0.8)
        ax.plot(line["f_2px"], i, **style.look(method))
    layout.method_axis(ax, style, methods)
    ax.set_xlabel("F at 2 px, all views pooled")
    ax.set_xlim(right=min(1.005, ax.get_xlim()[1]))
    entries = [("pooled (hollow: a preset)", {"color": INK, "marker": "o", "linestyle": ""}),
               ("95 % interval", {"color": MIST, "linewidth": 3})]
    if summary["f_train"].notna().any():
        entries.append(("training scenes", {"color": FAINT, "marker": "|", "linestyle": ""}))
    if summary["f_heldout"].notna().any():
        entries.append(("held-out scenes", {"color": INK, "marker": "x", "linestyle": "",
                                            "markersize": 3 * style.scale}))
    if "f_real" in summary and summary["f_real"].notna().any():
        entries.append(("real models", {"color": INK, "marker": "+", "linestyle": "",
                                        "markersize": 4 * style.scale}))
    for name, (label, dashes) in ONE_SAMPLE.items():
        if name not in summary.index:
            continue
        ax.axvline(summary.loc[name, "f_2px"], color=FAINT, linestyle=dashes, linewidth=1)
        entries.append((label, {"color": FAINT, "linestyle": dashes, "linewidth": 1}))
    layout.key(figure, style, entries)
    best = summary.loc[methods, "f_2px"].sort_values(ascending=False)
    facts = answer_of(summary.loc[methods])[1] + ["highest F: " + "; ".join(
        f"{m} {summary.loc[m, 'f_2px']:.3f}{_interval(summary.loc[m])}" for m in best.index[:3])]
    return Chart(figure, "F at 2 px of each method, with 95 % intervals (scenes "
                 "resampled with all their views). " + _extent(runs) + runs.source("summary.csv"),
                 facts)


def _interval(line):
    """" [0.912, 0.934]", or "" where too few scenes give none."""
    return "" if pd.isna(line["f_lo"]) else f" [{line['f_lo']:.3f}, {line['f_hi']:.3f}]"


def _extent(runs):
    rows = runs.table_if_any("rows.csv")
    return "" if rows is None else f"Over {extent(rows)}. "


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


def heat_map(style, table, label, methods=None, digits=3, is_loss=False):
    """A figure of a table, columns from left to right; numbers where they have room.

    The scale begins where the data is; dark is low, or high if `is_loss`. methods: the rows are
    these methods.
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
    if methods is None:
        ax.set_yticks(range(len(table)), table.index)
    else:
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
    figure = heat_map(style, recalls, "recall at 2 px", methods)
    absent = [title for name, title in RECALL_GROUPS.items() if name not in there]
    facts = [f"{name}: {recalls[name].idxmax()} {recalls[name].max():.3f} at best, "
             f"{recalls[name].idxmin()} {recalls[name].min():.3f} at worst" for name in recalls]
    caption = (f"Recall at 2 px by class of line, views pooled. Over {extent(rows)}. "
               + (f"Classes that these scenes do not have are left out: {', '.join(absent)}. "
                  if absent else "") + runs.source("rows.csv"))
    return Chart(figure, caption, facts)


def scenes_by_methods(runs, style):
    """F of each method on each scene."""
    rows = runs.table_of_methods("rows.csv")
    methods = style.by_family(rows["method"])
    if not methods:
        raise Nothing("the run has no method beside the baselines")
    table = pooled(rows, ["scene", "method"]).pivot(index="scene", columns="method", values="f")
    order = table.mean(axis=1).sort_values(ascending=False, kind="stable").index
    table = table.loc[order, methods]
    figure = heat_map(style, table, "F at 2 px", digits=2)
    hardest = table.mean(axis=1)
    facts = [f"easiest scene {hardest.index[0]} (mean F {hardest.iloc[0]:.3f}), hardest "
             f"{hardest.index[-1]} ({hardest.iloc[-1]:.3f})"]
    for method in methods:
        facts.append(f"{method}: least F {table[method].min():.3f} on {table[method].idxmin()}")
    return Chart(figure, "F at 2 px of each method on each scene, the views of a scene pooled; the "
                 f"scenes from easy to hard. Over {extent(rows)}. " + runs.source("rows.csv"),
                 facts)


def causes(runs, style):
    """Why pixels are wrong: missing lines to the left, false ones to the right."""
    rows = runs.table_of_methods("rows.csv")
    columns = list(MISSING_CAUSES) + list(FALSE_CAUSES)
    if rows[columns].isna().all().all():
        raise Nothing("the run asked for no causes (full_scores = false)")
    methods = style.by_family(rows["method"])
    sums = rows.groupby("method")[columns + ["n_truth"]].sum().reindex(methods)
    percent = 100 * sums.div(sums["n_truth"], axis=0)
    figure, axes = layout.new_figure(style, layout.rows_height_in(style, len(methods)), 1, 2,
                                     sharey=True)
    entries = []
    for ax, of_kind, kind in zip(axes[0], (MISSING_CAUSES, FALSE_CAUSES), ("missing", "false")):
        start = percent["n_truth"] * 0
        for cause, (words, tone) in of_kind.items():
            if sums[cause].sum() > 0:
                entries.append((f"{kind}: {words}", {"patch": {"color": tone, "linewidth": 0}}))
            ax.barh(range(len(methods)), percent[cause], left=start, height=0.74, color=tone,
                    linewidth=0)
            start = start + percent[cause]
        layout.method_axis(ax, style, methods)
    axes[0, 0].invert_xaxis()
    axes[0, 0].set_xlabel("missing, % of true pixels")
    axes[0, 1].set_xlabel("false, % of true pixels")
    layout.key(figure, style, entries)
    facts = []
    for kind, of_kind in (("missing", MISSING_CAUSES), ("false", FALSE_CAUSES)):
        total = sums[list(of_kind)].sum().sort_values(ascending=False)
        if total.sum() > 0:
            facts.append(f"{kind}, all methods: " + ", ".join(
                f"{of_kind[c][0].split(':')[0]} {total[c] / total.sum():.0%}"
                for c in total.index[:3]))
    return Chart(figure, "Missing and false pixels by their cause, as a share of the true pixels, "
                 f"views pooled. Over {extent(rows)}. " + runs.source("rows.csv"), facts)


def panels_by_family(style, groups, height_in, most=2, **keywords):
    """A panel a family, at most `most` beside each other, with its title; room for labels."""
    rows, columns = layout.grid_of(len(groups), style.columns(70, most))
    figure, axes = layout.new_figure(style, height_in * rows, rows, columns, **keywords)
    for ax, (name, members) in zip(axes.flat, groups.items()):
        ax.set_title(name, color=style.text_colour(members[0]))
    layout.hide_rest(axes, len(groups))
    return figure, axes


def tolerances(runs, style):
    """Error over the tolerance within which a match counts."""
    frame = runs.table_of_methods("tolerances.csv")
    points = pooled(frame, ["method", "tolerance_px"], k="k")
    groups = style.families_of(points["method"])
    figure, axes = panels_by_family(style, groups, 2.0, sharey=True, sharex=True)
    panels = []
    for ax, members in zip(axes.flat, groups.values()):
        ends = []
        for method in members:
            own = points[points["method"] == method].sort_values("tolerance_px")
            ax.plot(own["tolerance_px"], own["error"], **{**style.look(method, True),
                                                          "markersize": 3 * style.scale})
            ends.append((own["tolerance_px"].iloc[-1], own["error"].iloc[-1], method))
        ax.set_yscale("log")
        layout.plain_ticks(ax, x=False)
        ax.set_xlim(0.9, 4.1)
        ax.set_xticks([1, 2, 3, 4])
        panels.append((ax, ends))
    figure.supxlabel("tolerance, px")
    figure.supylabel("error 1 − F, all views pooled")
    layout.label_ends(figure, style, panels)
    wide = points.pivot(index="method", columns="tolerance_px", values="f")
    gain = (wide[wide.columns.max()] - wide[wide.columns.min()]).dropna().sort_values()
    facts = [f"from {wide.columns.min():g} to {wide.columns.max():g} px F grows most for "
             f"{gain.index[-1]} (+{gain.iloc[-1]:.3f}), least for {gain.index[0]} "
             f"(+{gain.iloc[0]:.3f})"]
    return Chart(figure, "Error over the tolerance within which a drawn pixel matches a true one, "
                 "by family of methods. " + runs.source("tolerances.csv"), facts)


def differences(runs, style):
    """Who is better than whom, paired by scene, and whether chance in the scenes explains it."""
    frame = runs.differences()
    methods = list(dict.fromkeys(frame["method"]))
    wide = frame.pivot(index="method", columns="other", values="difference") \
        .reindex(index=methods, columns=methods)
    sure = frame.assign(sure=(frame["lo_of_all"] > 0) | (frame["hi_of_all"] < 0)) \
        .pivot(index="method", columns="other", values="sure").reindex(index=methods,
                                                                      columns=methods)
    count = len(methods)
    label = "F of the row less F of the column, thousandths"
    figure, axes = layout.new_figure(
        style, _height_in(style, count, 10, label))
    ax = axes[0, 0]
    most = max(0.01, min(0.15, wide.abs().max().max()))
    shown = ax.imshow(1000 * wide.where(sure == True), cmap="PuOr_r", vmin=-1000 * most,  # noqa: E712
                      vmax=1000 * most, aspect="auto")
    cell_in = (style.width_in - 24 * style.font_pt / 72) / count
    size = style.small_pt
    if cell_in > 3.3 * 0.55 * size / 72:
        for i in range(count):
            for j in range(count):
                value = wide.iloc[i, j]
                if pd.notna(value):
                    strong = sure.iloc[i, j] and abs(value) > 0.62 * most
                    ax.text(j, i, f"{1000 * value:+.0f}".replace("-", "−"), ha="center",
                            va="center", fontsize=size,
                            color="white" if strong else INK if sure.iloc[i, j] else FAINT)
    ax.set_xticks(range(count), methods, rotation=50, ha="right", rotation_mode="anchor")
    ax.set_yticks(range(count), methods)
    ax.tick_params(length=0)
    ax.grid(visible=False)
    bar = figure.colorbar(shown, ax=ax, fraction=0.04, pad=0.015, extend="both",
                          label=label)
    bar.outline.set_visible(False)
    pairs = sure.stack()
    facts = [f"in {int(pairs.sum() / 2)} of {len(pairs) // 2} pairs one leads beyond chance (95 %, all "
             "pairs together)"]
    return Chart(figure, "Paired differences of F at 2 px in thousandths: the method of the row "
                 "less that of the column, over the views that both have. White cells: neither "
                 "leads, for its 95 % interval (scenes resampled, all pairs together) holds 0. "
                 + runs.source("differences.csv"), facts)


# A bar of a class, for charts of scenes.
def class_key():
    """Entries of a legend of the classes."""
    return [(name, {"patch": {"color": CLASS_COLOURS[name], "linewidth": 0}}) for name in CLASSES]
