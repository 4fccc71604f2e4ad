"""How figures look: vector, a journal's two widths, colours of Okabe and Ito, labels at the lines.

A family of methods has a colour, a method of it a marker, both as the run's methods.csv says; a
tuned row is its method's, hollow.
`save` writes the SVG and returns it for the notebook: the same bytes for the same rows.
"""

import io
import math
import os
from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the back end)
from IPython.display import SVG  # noqa: E402
from matplotlib.colors import to_hex, to_rgb  # noqa: E402
from matplotlib.patheffects import withStroke  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator  # noqa: E402
from matplotlib.transforms import ScaledTranslation  # noqa: E402

import runs  # noqa: E402

FOLDER = Path(os.environ.get("INKBENCH_FIGURES", "figures"))
NARROW, WIDE = 3.4, 7.0  # inches: one column of a paper, both

# As src/draw/palette.h has them (Okabe and Ito, Color Universal Design, 2008).
INK, FAINT, MIST = "#20242a", "#5b6470", "#cdd1d6"
BLUE, VERMILION, GREEN = "#0072b2", "#d55e00", "#009e73"
PURPLE, ORANGE, SKY = "#cc79a7", "#e69f00", "#56b4e9"
CLASS_COLOURS = {"contour": INK, "boundary": PURPLE, "crease": GREEN, "intersection": ORANGE,
                 "seam": SKY}
CAUSE_COLOURS = {
    "false_positives_one_triangle": BLUE, "false_positives_one_patch": "#74b9f2",
    "false_positives_crack": "#2ccf96", "false_positives_frame": "#2a1fb0",
    "false_positives_other": "#a060f0", "false_negatives_cancelled": VERMILION,
    "false_negatives_below_threshold": "#f2b400", "false_negatives_sub_pixel": "#6b4410",
    "false_negatives_thinned": "#ee3377", "false_negatives_unexplained": "#8a1560",
    "false_negatives_undeclared": "#d98a3a",
}

# A family in methods.csv: its word in legends, and its colour as the report has it.
OTHERS = "other"
FAMILIES = {"packed": ("packed", BLUE), "full_buffers": ("full buffers", VERMILION),
            "ids": ("ids", GREEN), "edges_and_hulls": ("edges, hulls", PURPLE),
            "other": (OTHERS, INK)}
# A marker there, and what Matplotlib calls it; within a family methods stand in this order.
SHAPES = {"circle": "o", "square": "s", "diamond": "D", "up": "^", "down": "v", "plus": "P",
          "cross": "X", "left": "<", "right": ">"}
MARKERS = list(SHAPES.values())
BASELINES = ["none", "sampled", "oracle"]

STYLE = {
    "font.family": "DejaVu Sans", "font.size": 7.5, "axes.titlesize": 8, "axes.labelsize": 7.5,
    "xtick.labelsize": 7, "ytick.labelsize": 7, "legend.fontsize": 7, "legend.frameon": False,
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": FAINT,
    "axes.linewidth": 0.6, "axes.labelcolor": INK, "axes.titlelocation": "left",
    "text.color": INK, "xtick.color": FAINT, "ytick.color": FAINT, "xtick.labelcolor": INK,
    "ytick.labelcolor": INK, "xtick.major.width": 0.6, "ytick.major.width": 0.6,
    "axes.grid": True, "grid.color": "#e8eaed", "grid.linewidth": 0.6, "axes.axisbelow": True,
    "lines.linewidth": 1.2, "lines.markersize": 4, "figure.constrained_layout.use": True,
    "figure.dpi": 72, "svg.fonttype": "path", "svg.hashsalt": "inkbench",
}
plt.rcParams.update(STYLE)


def _fact(method, column):
    """A field of methods.csv; "" for a method that no run and no program lists."""
    known = runs.methods()
    return known.at[method, column] if method in known.index else ""


def base(method):
    """The method whose settings a preset changes; else the method itself."""
    return _fact(method, "preset_of") or method.removesuffix("_tuned")


def _family(method):
    return _fact(method, "family") or _fact(base(method), "family") or "other"


def _place(method):
    """Where the method stands in its family, by its marker."""
    return list(SHAPES).index(_fact(method, "marker") or _fact(base(method), "marker") or "circle")


def family(method):
    """The word for the method's family in legends."""
    return FAMILIES[_family(method)][0]


def colour(method):
    """The colour of the method's family."""
    return FAINT if method in BASELINES else FAMILIES[_family(method)][1]


def shade(method):
    """The method's own, darker or lighter, so that neighbours in a family differ in grey too."""
    towards, share = [(INK, 0), (INK, 0.55), ("#ffffff", 0.35), (INK, 0.3), ("#ffffff", 0.55)][
        _place(method) % 5]
    mixed = [a + share * (b - a) for a, b in zip(to_rgb(colour(method)), to_rgb(towards))]
    return to_hex(mixed)


def look(method, is_shaded=False):
    """Keywords of `plot` that tell a method from the others; shaded where a family has a panel."""
    tone = shade(method) if is_shaded else colour(method)
    hollow = base(method) != method
    return {"color": tone, "marker": MARKERS[_place(method)],
            "markerfacecolor": "white" if hollow else tone, "markeredgewidth": 0.9,
            "linestyle": "--" if hollow else "-"}


def by_family(methods):
    """The methods (baselines left out) in the order of families, presets behind their own."""
    methods = [m for m in dict.fromkeys(methods) if m not in BASELINES]
    order = list(FAMILIES)
    return sorted(methods, key=lambda m: (order.index(_family(m)), _place(m), base(m), base(m) != m))


def families_of(methods):
    """Family -> its methods, in order, families without one left out."""
    groups = {}
    for method in by_family(methods):
        groups.setdefault(family(method), []).append(method)
    return groups


def method_axis(ax, methods):
    """Methods from top to bottom as ticks in their colour, a rule between families."""
    ax.set_yticks(range(len(methods)), methods)
    ax.set_ylim(len(methods) - 0.4, -0.6)
    ax.grid(axis="y", visible=False)
    ax.tick_params(axis="y", length=0)
    for label, method in zip(ax.get_yticklabels(), methods):
        label.set_color(INK if family(method) == OTHERS else colour(method))
    for i in range(1, len(methods)):
        if family(methods[i]) != family(methods[i - 1]):
            ax.axhline(i - 0.5, color=MIST, linewidth=0.6)


def label_ends(ax, ends, x_px=4, gap=1.15):
    """Texts to the right of lines: (x, y, text, colour) each, moved apart where they would touch.

    Call it when limits stand; the axes must leave room at their right.
    """
    ax.figure.draw_without_rendering()
    to_px, size = ax.transData.transform, plt.rcParams["font.size"] - 1
    height = size * ax.figure.dpi / 72 * gap
    placed = sorted(((to_px((x, y)), text, tone) for x, y, text, tone in ends),
                    key=lambda end: end[0][1])
    ys = []
    for (_, y), _, _ in placed:
        ys.append(max(y, ys[-1] + height) if ys else y)
    top = ax.get_window_extent().y1
    if ys and ys[-1] > top:
        ys[-1] = top
        for i in range(len(ys) - 2, -1, -1):
            ys[i] = min(ys[i], ys[i + 1] - height)
    scale = 72 / ax.figure.dpi
    for ((x, y), text, tone), y_text in zip(placed, ys):
        ax.annotate(text, xy=ax.transData.inverted().transform((x, y)), xycoords="data",
                    xytext=(x_px, (y_text - y) * scale), textcoords="offset points",
                    color=tone, fontsize=size, va="center", annotation_clip=False)


def label_points(ax, points):
    """Texts beside points: (x, y, text, colour) each, at the first of twelve places that is free.

    Call it when limits stand. A text that stands away from its point gets a thin line to it.
    """
    figure = ax.figure
    figure.draw_without_rendering()
    size, scale = 6.5, 72 / figure.dpi
    inside = ax.get_window_extent()
    dots = [ax.transData.transform((x, y)) for x, y, _, _ in points]
    taken = [(x - 3, y - 3, x + 3, y + 3) for x, y in dots]

    def touches(a, b):
        return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]

    for (x, y), (_, _, text, tone) in zip(dots, points):
        probe = ax.text(0, 0, text, fontsize=size)
        extent = probe.get_window_extent()
        probe.remove()
        w, h = extent.width, extent.height
        best = None
        for far in (5, 12, 20, 30, 42, 56):
            for dx, dy in ((far, -h / 2), (-far - w, -h / 2), (-w / 2, far), (-w / 2, -far - h),
                           (far, far / 2), (far, -far / 2 - h), (-far - w, far / 2),
                           (-far - w, -far / 2 - h)):
                box = (x + dx, y + dy, x + dx + w, y + dy + h)
                free = not any(touches(box, other) for other in taken)
                if free and box[0] > inside.x0 and box[2] < inside.x1 + 40 and (
                        inside.y0 < box[1] and box[3] < inside.y1):
                    best = (dx, dy, box, far)
                    break
            if best:
                break
        dx, dy, box, far = best or (5, -h / 2, (x + 5, y - h / 2, x + 5 + w, y + h / 2), 5)
        taken.append(box)
        line = {"arrowstyle": "-", "color": MIST, "linewidth": 0.5, "shrinkA": 0, "shrinkB": 2}
        ax.annotate(text, xy=ax.transData.inverted().transform((x, y)),
                    xytext=(dx * scale, dy * scale), textcoords="offset points", color=tone,
                    fontsize=size, va="bottom", arrowprops=line if far > 5 else None,
                    path_effects=[withStroke(linewidth=2, foreground="white")])


def key(figure, entries, columns=None):
    """A legend above all axes: (label, keywords of a line) each."""
    handles = [plt.Line2D([], [], label=label, **keywords) for label, keywords in entries]
    figure.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.0),
                  ncol=columns or len(entries), handlelength=1.6, columnspacing=1.4,
                  borderaxespad=0.2)


def key_in(ax, members, below_pt=26):
    """The methods of one panel with their markers, below its ticks and the label of its axis."""
    handles = [plt.Line2D([], [], label=m, markersize=3.5, **look(m, True)) for m in members]
    down = ScaledTranslation(-4 / 72, -below_pt / 72, ax.figure.dpi_scale_trans)
    ax.legend(handles=handles, loc="upper left", bbox_to_anchor=(0, 0), fontsize=6.5,
              bbox_transform=ax.transAxes + down, handlelength=1.8, labelspacing=0.25,
              borderaxespad=0, borderpad=0)


def middle(axes):
    """The axes in the middle of a row: the label of all stands under it."""
    return axes[len(axes) // 2]


def plain_ticks(ax, x_only=False, y_only=False):
    """Ticks of a logarithmic axis at 1, 2, 5 times powers of ten, as plain numbers."""
    axes = [ax.xaxis] if x_only else [ax.yaxis] if y_only else [ax.xaxis, ax.yaxis]
    for axis in axes:
        low, high = sorted(axis.get_view_interval())
        decades = math.log10(high / low) if low > 0 else 9
        axis.set_major_locator(LogLocator(subs=(1, 2, 5) if decades < 2.2 else (1,), numticks=20))
        axis.set_minor_locator(NullLocator())
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def save(figure, name):
    """Writes figures/<name>.svg and returns the same for the notebook. No date goes in."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="svg", bbox_inches="tight", pad_inches=0.04,
                   metadata={"Date": None, "Creator": None})
    plt.close(figure)
    FOLDER.mkdir(parents=True, exist_ok=True)
    (FOLDER / f"{name}.svg").write_bytes(buffer.getvalue())
    return SVG(buffer.getvalue())
