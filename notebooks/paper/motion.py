"""What the eye sees when things move: flicker, pops, lives of false lines, a cube that rolls."""

from paper import layout
from paper.chart import Chart, Nothing
from paper.methods import panels_by_family
from paper.runs import counted
from paper.style import (BLUE, FAINT, GREEN, INK, MARKERS, MISSING, ORANGE, PURPLE, SKY, VERMILION,
                         mixed)

_ADVICE = "`inkbench compare --motion` or `inkbench run experiments/animation.toml` writes it"
_COUNTS = ["appeared_px", "disappeared_px", "counted_px", "pops", "feature_steps"]
_PATH_TONES = [INK, BLUE, VERMILION, GREEN, PURPLE, mixed(ORANGE, INK, 0.2), mixed(SKY, INK, 0.2)]


def flicker(runs, style):
    """Flicker and pops of each method on each path of the camera."""
    motion = runs.table_of_methods("motion.csv", _ADVICE)
    methods = style.by_family(motion["method"])
    paths = list(dict.fromkeys(motion["view"]))
    sums = motion.groupby(["method", "view"])[_COUNTS].sum().reset_index()
    sums["flicker"] = 100 * (sums["appeared_px"] + sums["disappeared_px"]) / sums["counted_px"]
    sums["pops_per_s"] = sums["pops"] / sums["feature_steps"] * motion["frames_per_s"].max()
    figure, axes = layout.new_figure(style, layout.rows_height_in(style, len(methods)), 1, 2,
                                     sharey=True)
    looks = {path: {"marker": MARKERS[i % len(MARKERS)], "linestyle": "",
                    "color": _PATH_TONES[i % len(_PATH_TONES)], "markerfacecolor": "none",
                    "markersize": max(3, 5.5 - 0.5 * i) * style.scale}
             for i, path in enumerate(paths)}
    for ax, column, title in (
            (axes[0, 0], "flicker", "flicker beyond the truth's,\n% of drawn pixels"),
            (axes[0, 1], "pops_per_s", "pops per feature and second")):
        for path in paths:
            own = sums[sums["view"] == path].set_index("method")[column].reindex(methods)
            ax.plot(own, range(len(methods)), clip_on=False, **looks[path])
        ax.set_xscale("symlog", linthresh=0.01)
        ax.set_xlim(left=0)
        ax.set_xticks([t for t in ax.get_xticks() if t <= ax.get_xlim()[1]])
        ax.minorticks_off()
        ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        layout.method_axis(ax, style, methods)
        ax.set_xlabel(title)
    layout.key(figure, style, [(path.replace("_", " "), look) for path, look in looks.items()])
    total = sums.groupby("method")[_COUNTS].sum()
    share = (100 * (total["appeared_px"] + total["disappeared_px"]) / total["counted_px"])[methods]
    facts = [f"flicker over all paths: least {share.idxmin()} {share.min():.3f} %, most "
             f"{share.idxmax()} {share.max():.3f} %"]
    sizes = ", ".join(f"{w}x{h}" for w, h in motion[["width", "height"]].drop_duplicates().values)
    frames = sorted(motion["frames"].unique())
    return Chart(figure, "Flicker beyond the truth's own change, and pops of persistent lines. A "
                 "mark is a path of the camera, all its scenes pooled; both scales are linear up to "
                 f"0.01. {counted(len(motion.groupby(['scene', 'view'])), 'sequence')} of "
                 f"{' or '.join(map(str, frames))} frames of {sizes} px. "
                 + runs.source("motion.csv"), facts)


def lives(runs, style):
    """How many false lines live so many frames or longer."""
    motion = runs.table("motion.csv", _ADVICE)
    lines = runs.table("lives.csv", "no method draws a false line")
    methods = style.by_family(motion["method"])
    groups = style.families_of(methods)
    figure, axes = panels_by_family(style, groups, 2.1, sharey=True, sharex=True)
    ends, facts = [], []
    for ax, members in zip(axes.flat, groups.values()):
        own_ends = []
        for method in members:
            own = lines[lines["method"] == method]
            if not len(own):
                facts.append(f"{method}: no false line")
                continue
            counts = own.groupby("frames")["count"].sum().sort_index()
            living = counts[::-1].cumsum()[::-1]
            ax.step(living.index, living.values, where="post",
                    **{**style.look(method, True), "markersize": 3 * style.scale,
                       "linewidth": 0.9 * style.scale})
            own_ends.append((living.index[-1], living.values[-1], method))
            total = int(counts.sum())
            facts.append(f"{method}: {counted(total, 'false line')}, "
                         f"{counts.get(1, 0) / total:.0%} of them for one frame")
        layout.log_axes(ax)
        ends.append((ax, own_ends))
    figure.supylabel("false lines with this life or longer")
    figure.supxlabel("life, frames")
    layout.label_ends(figure, style, ends)
    return Chart(figure, "How long false lines live: how many are there for so many frames or "
                 "longer, by family. " + runs.source("lives.csv"), facts)


def _creases(runs):
    return runs.table("creases.csv", _ADVICE)


def roll(runs, style):
    """The drawn share of a cube's creases while the camera rolls, and where it was predicted lost."""
    frame = _creases(runs)
    angles = runs.table_if_any("vanishing.csv")
    methods = [m for m in style.by_family(frame["method"])
               if frame.loc[frame["method"] == m, "predicted_step"].notna().any()]
    if not methods:
        raise Nothing("no method of the run declares a linear code")
    creases = sorted(frame["crease"].unique())
    figure, axes = layout.new_figure(style, 0.75 * len(methods) + 0.5, len(methods), len(creases),
                                     sharex=True, sharey=True)
    for line, method in zip(axes, methods):
        for ax, crease in zip(line, creases):
            own = frame[(frame["method"] == method) & (frame["crease"] == crease)]
            blind = own["predicted_blind"].fillna(False).astype(bool)
            ax.fill_between(own["value"], 0, 1, where=blind, step="mid", color=ORANGE,
                            alpha=0.35, linewidth=0)
            if angles is not None:
                at = angles[(angles["method"] == method) & (angles["crease"] == crease)]
                for _, angle in at.iterrows():
                    is_lost = angle["recall_there"] < 0.5
                    ax.axvline(angle["predicted_deg"], color=MISSING if is_lost else FAINT,
                               linestyle="--" if is_lost else ":", linewidth=0.8)
            ax.plot(own["value"], own["covered_px"] / own["length_px"], color=BLUE,
                    linewidth=0.9 * style.scale)
            ax.set_xlim(0, 360)
            ax.set_xticks([0, 90, 180, 270])
            ax.set_ylim(0, 1.05)
            ax.set_yticks([0, 0.5, 1])
        line[0].set_ylabel(method.replace("_", "_\n"), color=style.text_colour(method),
                           fontsize=style.small_pt, rotation=0, ha="right", va="center")
    for ax, crease in zip(axes[0], creases):
        ax.set_title(f"crease {crease}")
    figure.supxlabel("roll of the camera, degrees")
    figure.supylabel("drawn share of the crease")
    entries = [("measured", {"color": BLUE}),
               ("predicted: no step, crease lost", {"color": MISSING, "linestyle": "--"}),
               ("predicted: no step, yet drawn", {"color": FAINT, "linestyle": ":"}),
               ("predicted: too small a step", {"patch": {"color": ORANGE, "alpha": 0.35}})]
    layout.key(figure, style, entries)
    facts = []
    if angles is not None:
        off = angles["error_deg"].abs()
        facts.append(f"{len(angles)} angles predicted, {angles['measured_deg'].notna().sum()} of "
                     f"them found, off by {off.median():.2f} degrees in the median, "
                     f"{off.max():.2f} at most")
        drawn = angles[angles["recall_there"] >= 0.5]
        for method, own in drawn.groupby("method"):
            facts.append(f"{method}: at {counted(len(own), 'predicted angle')} more than half of "
                         "the crease is drawn all the same")
    return Chart(figure, "Drawn share of three creases of a cube while the camera rolls once round. "
                 "Dashes: angles at which the declared code has no step across the crease, "
                 "predicted from the code and the cube alone. " + runs.source("creases.csv"), facts)


def roll_least(runs, style):
    """The least and the mean share of a crease that each method draws over a whole roll."""
    frame = _creases(runs)
    frame = frame.assign(share=frame["covered_px"] / frame["length_px"])
    spread = frame.groupby("method")["share"].agg(["min", "mean"])
    spread = spread.loc[style.by_family(spread.index)]
    figure, axes = layout.new_figure(style, layout.rows_height_in(style, len(spread)))
    ax = axes[0, 0]
    for i, (method, line) in enumerate(spread.iterrows()):
        ax.plot([line["min"], line["mean"]], [i, i], color=style.colour(method), linewidth=1,
                alpha=0.5)
        ax.plot(line["min"], i, "|", color=style.colour(method), markersize=6 * style.scale)
        ax.plot(line["mean"], i, **style.look(method))
    layout.method_axis(ax, style, list(spread.index))
    ax.set_xlim(-0.02, 1.02)
    ax.set_xlabel("drawn share of a crease over a whole roll")
    layout.key(figure, style, [("least", {"color": INK, "marker": "|", "linestyle": ""}),
                               ("mean", {"color": INK, "marker": "o", "linestyle": ""})])
    always = spread[spread["min"] > 0.5].index
    return Chart(figure, "The share of a cube's creases that is drawn while the camera rolls once "
                 "round: at the worst angle, and in the mean. " + runs.source("creases.csv"),
                 [f"never below one half: {', '.join(always) or 'none'}"])
