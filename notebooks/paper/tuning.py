"""How parameters are chosen: grids of two, the search, tuned beside hand-set, the linear bound."""

import pandas as pd

from paper import layout
from paper.chart import Chart, Nothing
from paper.methods import heat_map
from paper.runs import counted, file_name, pooled, with_settings
from paper.style import BLUE, FAINT, INK, MISSING, MIST, ORANGE, VERMILION


def grids(runs, style):
    """A heat map a method: the best F over every two steps of its grid, all views pooled.

    Of a packing's ranges it is depth against the sum of the normal's; else the two parameters that
    the sweep varies most.
    """
    sweep = runs.table("sweep.csv", "`inkbench run` with a [sweep.METHOD] writes it")
    charts = []
    for method in style.by_family(sweep["method"]):
        settings = with_settings(sweep[sweep["method"] == method])
        axes = _grid_axes(settings)
        if axes is None:
            continue
        charts.append(_grid(runs, style, method, settings, *axes))
    if not charts:
        raise Nothing("no sweep in it crosses two parameters")
    return charts


def _grid_axes(settings):
    """Columns of the two axes, each a list (summed), or None if no two parameters are crossed."""
    own = [c for c in dict(pair.split("=", 1) for pair in settings["params"].iloc[0].split(";"))
           if settings[c].nunique() > 1 and pd.to_numeric(settings[c], errors="coerce").notna().all()]
    ranges = [c for c in own if c.startswith("range_")]
    if "range_depth" in ranges and len(ranges) > 1:
        return ["range_depth"], [c for c in ranges if c != "range_depth"]
    others = sorted((c for c in own if c != "threshold"), key=lambda c: -settings[c].nunique())
    for second in others[1:] + (["threshold"] if "threshold" in own else []):
        pairs = settings[[others[0], second]].drop_duplicates()
        if len(pairs) >= 0.9 * settings[others[0]].nunique() * settings[second].nunique() > 3:
            return [second], [others[0]]
    return None


def _words(columns):
    return " + ".join([columns[0]] + [c.removeprefix("range_") for c in columns[1:]])


def _grid(runs, style, method, settings, across, down):
    at = {"across": settings[across].astype(float).sum(axis=1),
          "down": settings[down].astype(float).sum(axis=1)}
    settings = settings.assign(**at)
    points = pooled(settings, ["across", "down", "params"])
    table = points.groupby(["down", "across"])["f"].max().unstack("across")
    table = table.sort_index(ascending=False)
    table.columns = [f"{v:g}".replace("-", "−") for v in table.columns]
    labels = [f"{v:g}".replace("-", "−") for v in table.index]
    figure = heat_map(style, table, "F at 2 px", digits=3)
    ax = figure.axes[0]
    ax.set_yticks(range(len(labels)), labels)
    ax.set_xlabel(_words(across))
    ax.set_ylabel(_words(down))
    ax.set_title(method, color=style.text_colour(method))
    _mark_own(ax, runs, method, across, down, table, labels)
    top = points.loc[points["f"].idxmax()]
    facts = [f"{method}: {counted(len(points), 'setting')}, F {points['f'].min():.3f} to "
             f"{top['f']:.3f}, best at {_words(across)} {top['across']:g}, {_words(down)} "
             f"{top['down']:g}"]
    return Chart(figure, f"F at 2 px of {method} over {_words(across)} and {_words(down)}, all views "
                 "pooled; a cell is the best over all other parameters. Black frame: the method's "
                 "own setting. " + runs.source("sweep.csv"), facts, file_name(method))


def _mark_own(ax, runs, method, across, down, table, labels):
    """A frame round the cell of the method's own setting, if the grid has it."""
    folder = runs.folder_with("sweep.csv")
    rows = folder.table("rows.csv")
    own = rows[rows["method"] == method]
    if not len(own):
        return
    own = with_settings(own.head(1)).iloc[0]
    x = f"{sum(float(own[c]) for c in across):g}".replace("-", "−")
    y = f"{sum(float(own[c]) for c in down):g}".replace("-", "−")
    if x in table.columns and y in labels:
        i, j = list(table.columns).index(x), labels.index(y)
        ax.plot([i - 0.5, i + 0.5, i + 0.5, i - 0.5, i - 0.5],
                [j - 0.5, j - 0.5, j + 0.5, j + 0.5, j - 0.5], color="black", linewidth=1.6,
                clip_on=False, zorder=5)


def sweep_lines(runs, style):
    """F, precision and recall along each parameter of a sweep, the others at the method's own."""
    sweep = runs.table("sweep.csv", "`inkbench run` with a [sweep.METHOD] writes it")
    rows = runs.table("rows.csv")
    charts = []
    for method in style.by_family(sweep["method"]):
        settings = with_settings(sweep[sweep["method"] == method])
        own = with_settings(rows[rows["method"] == method].head(1))
        if not len(own):
            continue
        lines = _lines_of(settings, own.iloc[0])
        if lines:
            charts.append(_line_chart(runs, style, method, lines, own.iloc[0]))
    if not charts:
        raise Nothing("no sweep in it varies a number alone in four steps or more")
    return charts


def _lines_of(settings, own):
    """Parameter -> its points (value, f, precision, recall) with all others at the own setting."""
    names = list(dict(pair.split("=", 1) for pair in settings["params"].iloc[0].split(";")))
    varied = [n for n in names if settings[n].nunique() > 1]
    lines = {}
    for name in varied:
        others = [n for n in varied if n != name]
        at_own = (settings[others] == own[others]).all(axis=1) if others else settings.index >= 0
        along = settings[at_own]
        value = pd.to_numeric(along[name], errors="coerce")
        if value.nunique() < 4 or value.isna().any():
            continue
        sums = along.assign(value=value).groupby("value")[["k_2px", "n_pred", "n_truth"]].sum()
        lines[name] = pd.DataFrame({
            "F": 2 * sums["k_2px"] / (sums["n_pred"] + sums["n_truth"]),
            "precision": sums["k_2px"] / sums["n_pred"],
            "recall": sums["k_2px"] / sums["n_truth"]})
    return lines


def _line_chart(runs, style, method, lines, own):
    rows, columns = layout.grid_of(len(lines), style.columns(54, 3))
    figure, axes = layout.new_figure(style, 1.5 * rows, rows, columns)
    looks = {"F": {"color": INK, "marker": "o"}, "precision": {"color": VERMILION, "marker": "^"},
             "recall": {"color": BLUE, "marker": "v"}}
    for ax, (name, points) in zip(axes.flat, lines.items()):
        places = range(len(points))
        for what, look in looks.items():
            ax.plot(places, points[what], markersize=3 * style.scale, **look)
        step = -(-len(points) // 9)
        ax.set_xticks(list(places)[::step], [f"{v:g}" for v in points.index][::step])
        ax.set_xlabel(name)
        if float(own[name]) in points.index:
            ax.axvline(list(points.index).index(float(own[name])), color=ORANGE, zorder=0.5,
                       linewidth=2 * style.scale)
    layout.hide_rest(axes, len(lines))
    axes[0, 0].set_title(method, color=style.text_colour(method))
    layout.key(figure, style, list(looks.items()) + [
        ("its own setting", {"color": ORANGE, "linewidth": 2 * style.scale})])
    facts = [f"{method}, {name}: best F {points['F'].max():.3f} at {points['F'].idxmax():g}, "
             f"{points['F'].min():.3f} at worst" for name, points in lines.items()]
    return Chart(figure, f"F, precision and recall of {method} along one parameter at a time, views "
                 "pooled; steps stand at even distances. " + runs.source("sweep.csv"), facts,
                 file_name(method))


def search(runs, style):
    """What `inkbench tune` tried, evaluation by evaluation, and the best so far."""
    found = runs.evaluations()
    rows, columns = layout.grid_of(len(found), style.columns(55, 3))
    figure, axes = layout.new_figure(style, 2.0 * rows, rows, columns)
    tones = {"start": INK, "global": BLUE, "local": VERMILION}
    facts = []
    for ax, (name, both) in zip(axes.flat, found.items()):
        tried = both[both["phase"] != "random"]
        for phase, points in tried.groupby("phase", sort=False):
            ax.plot(points["evaluation"], points["e_train"], ".", alpha=0.6, markeredgewidth=0,
                    color=tones.get(phase, FAINT), markersize=3 * style.scale)
        ax.step(tried["evaluation"], tried["e_train"].cummin(), where="post", color=INK,
                linewidth=1.1 * style.scale)
        by_random = both[both["phase"] == "random"]
        if len(by_random):
            ax.step(by_random["evaluation"], by_random["e_train"].cummin(), where="post",
                    color=FAINT, linewidth=style.scale, linestyle="--")
        ax.set_yscale("log")
        layout.plain_ticks(ax, x=False)
        ax.set_title(name, color=style.text_colour(name))
        ax.set_xlabel("evaluations")
        best = tried["e_train"].min()
        half = tried.loc[tried["e_train"].cummin() <= best * 1.01, "evaluation"].iloc[0]
        facts.append(f"{name}: {len(tried)} evaluations, error {tried['e_train'].iloc[0]:.4f} at "
                     f"first, {best:.4f} at last; within 1 % of that after {half}"
                     + (f"; random search {by_random['e_train'].min():.4f}"
                        if len(by_random) else ""))
    layout.hide_rest(axes, len(found))
    figure.supylabel("error on training views")
    layout.key(figure, style, [(phase, {"color": tone, "marker": ".", "linestyle": "",
                                        "markersize": 6}) for phase, tone in tones.items()] + [
        ("best so far", {"color": INK}), ("random search", {"color": FAINT, "linestyle": "--"})])
    return Chart(figure, "The search of `inkbench tune`: error on the training views of each "
                 "evaluation, the best so far, and that of as many random settings. Numbers: "
                 "`evaluations.csv` of the runs " + ", ".join(found) + ".", facts)


def tuned(runs, style):
    """Presets beside the methods whose settings they change."""
    summary = runs.summary()
    order = style.by_family(summary.index)
    pairs = [(style.base(m), m) for m in order if style.base(m) != m and style.base(m) in order]
    if not pairs:
        raise Nothing("no preset stands beside its method in this run")
    figure, axes = layout.new_figure(style, layout.line_height_in(style, 2.4 * len(pairs) + 4))
    ax = axes[0, 0]
    facts = []
    for i, pair in enumerate(pairs):
        for method, dy in zip(pair, (-0.16, 0.16)):
            line = summary.loc[method]
            ax.plot([line["f_lo"], line["f_hi"]], [i + dy] * 2, linewidth=2.4, alpha=0.35,
                    color=style.colour(method), solid_capstyle="butt")
            ax.plot(line["f_2px"], i + dy, **{**style.look(method), "linestyle": ""})
            ax.plot(line["f_heldout"], i + dy, "x", color=INK, markersize=3.5 * style.scale)
        hand, preset = pair
        facts.append(f"{preset}: F {summary.loc[hand, 'f_2px']:.3f} by hand, "
                     f"{summary.loc[preset, 'f_2px']:.3f} tuned; held out "
                     f"{summary.loc[hand, 'f_heldout']:.3f} and "
                     f"{summary.loc[preset, 'f_heldout']:.3f}")
    layout.method_axis(ax, style, [hand for hand, _ in pairs])
    ax.set_xlabel("F at 2 px, all views pooled")
    layout.key(figure, style, [
        ("by hand", {"color": INK, "marker": "o", "linestyle": ""}),
        ("tuned on training scenes", {"color": INK, "marker": "o", "linestyle": "",
                                      "markerfacecolor": "white"}),
        ("held-out scenes", {"color": INK, "marker": "x", "linestyle": "", "markersize": 3.5}),
        ("95 % interval", {"color": MIST, "linewidth": 3})])
    return Chart(figure, "Methods with parameters set by hand and tuned on the training scenes. "
                 + runs.source("summary.csv"), facts)


def bound(runs, style):
    """What any four weights could do on a scene, beside the method's own."""
    frame = runs.table("bound.csv", "`inkbench bound --method mote4` writes it")
    figure, axes = layout.new_figure(style, layout.rows_height_in(style, len(frame)))
    ax = axes[0, 0]
    places = range(len(frame))
    ax.hlines(places, frame["f_found"], frame["f_upper"], color=MIST, linewidth=3)
    ax.plot(frame["f_2px"], places, "s", color=BLUE)
    ax.plot(frame["f_found"], places, "|", color=INK, markersize=6 * style.scale)
    ax.plot(frame["f_upper"], places, "|", color=MISSING, markersize=6 * style.scale)
    ax.set_yticks(places, frame["scene"])
    ax.set_ylim(len(frame) - 0.4, -0.6)
    ax.grid(axis="y", visible=False)
    ax.set_xlabel("F at 2 px, views of the scene pooled")
    method = ", ".join(frame["method"].unique())
    layout.key(figure, style, [
        (method, {"color": BLUE, "marker": "s", "linestyle": ""}),
        ("best weights found", {"color": INK, "marker": "|", "linestyle": ""}),
        ("no weights do better", {"color": MISSING, "marker": "|", "linestyle": ""}),
        ("not decided", {"color": MIST, "linewidth": 3})])
    facts = [f"{line['scene']}: F {line['f_2px']:.3f}, found {line['f_found']:.3f}, at most "
             f"{line['f_upper']:.3f}" for _, line in frame.iterrows()
             if line["scene"].startswith("(")]
    return Chart(figure, "The most that any four weights of a linear code can reach on each scene, "
                 f"beside {method}. " + runs.source("bound.csv"), facts)
