"""Places on a figure: legends with room of their own, labels at lines and points, axes of methods."""

import math

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

from paper.style import FAINT, INK, MIST, OTHERS, PAPER

_PT = 1 / 72


def new_figure(style, height_in, rows=1, columns=1, **keywords):
    """A figure of the style's width with its axes as an array of `rows` x `columns`."""
    style.use()
    figure, axes = plt.subplots(rows, columns, figsize=(style.width_in, height_in), squeeze=False,
                                layout="constrained", **keywords)
    pad = 2 * _PT
    figure.get_layout_engine().set(w_pad=pad, h_pad=pad, wspace=0.02, hspace=0.03)
    return figure, axes


def line_height_in(style, lines=1):
    """Height of so many lines of a chart's names."""
    return lines * 1.45 * style.font_pt * _PT


def rows_height_in(style, count, extra_lines=3.2):
    """Height of a chart with so many methods or scenes below each other."""
    return line_height_in(style, count) + line_height_in(style, extra_lines)


def key(figure, style, entries):
    """A legend above all axes, as many columns as fit; the figure grows by its height.

    entries: (label, keywords of a line, or of a rectangle with `patch`) each.
    """
    handles = []
    for label, keywords in entries:
        if "patch" in keywords:
            handles.append(plt.Rectangle((0, 0), 1, 1, label=label, **keywords["patch"]))
        else:
            handles.append(plt.Line2D([], [], label=label, **keywords))
    figure.draw_without_rendering()
    for columns in range(len(handles), 0, -1):
        legend = figure.legend(handles=handles, loc="upper left", ncol=columns, handlelength=1.8,
                               columnspacing=1.2, borderaxespad=0, borderpad=0.1,
                               handletextpad=0.5, labelspacing=0.3,
                               bbox_to_anchor=(0.005, 1 - 2 * _PT / figure.get_figheight()))
        extent = legend.get_window_extent()
        if extent.width / figure.dpi <= 0.99 * style.width_in or columns == 1:
            break
        legend.remove()
    grown = extent.height / figure.dpi + 5 * _PT
    old = figure.get_figheight()
    figure.set_figheight(old + grown)
    figure.get_layout_engine().set(rect=(0, 0, 1, old / (old + grown)))
    legend.set_bbox_to_anchor((0.005, 1 - 2 * _PT / (old + grown)))


def name_axis(ax, style, names):
    """Names from top to bottom as ticks."""
    ax.set_yticks(range(len(names)), names, fontsize=style.small_pt)
    ax.set_ylim(len(names) - 0.4, -0.6)
    ax.grid(axis="y", visible=False)
    ax.tick_params(axis="y", length=0)


def method_axis(ax, style, methods):
    """Methods from top to bottom as ticks in their colour, a rule between families."""
    name_axis(ax, style, methods)
    for label, method in zip(ax.get_yticklabels(), methods):
        label.set_color(INK if style.family(method) == OTHERS else style.text_colour(method))
    for i in range(1, len(methods)):
        if style.family(methods[i]) != style.family(methods[i - 1]):
            ax.axhline(i - 0.5, color=MIST, linewidth=0.6)


def plain_ticks(ax, x=True, y=True):
    """Ticks of a logarithmic axis at 1, 2, 5 times powers of ten, as plain numbers."""
    for axis in [ax.xaxis] * x + [ax.yaxis] * y:
        low, high = sorted(axis.get_view_interval())
        decades = math.log10(high / low) if low > 0 else 9
        axis.set_major_locator(LogLocator(subs=(1, 2, 5) if decades < 2.9 else (1,), numticks=20))
        axis.set_minor_locator(NullLocator())
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))


def grid_of(count, most):
    """Rows and columns for so many panels, at most `most` beside each other, least left empty."""
    best = min(range(max(1, min(most, count) - 2), min(most, count) + 1),
               key=lambda columns: (-(-count // columns) * columns - count, -columns))
    return -(-count // best), best


def hide_rest(axes, count):
    """Switches off the panels after the first `count`; those under a gap keep their ticks."""
    for ax in axes.flat[count:]:
        ax.set_axis_off()
    rows, columns = axes.shape
    for i in range(count):
        if i + columns >= count and i // columns < rows - 1:
            axes.flat[i].tick_params(labelbottom=True)


def paper_box():
    """White behind a text that lies on lines: a rim round the letters would make paths of them."""
    return {"boxstyle": "square,pad=0.08", "facecolor": PAPER, "edgecolor": "none", "alpha": 0.8}


def label_ends(figure, style, panels):
    """Texts to the right of lines, moved apart where they would touch, with a line to their end.

    panels: (axes, [(x, y, method), ...]) each. Lines that end in one point get one text. Call
    it last, when limits and legends stand: the layout makes room at the right.
    """
    figure.draw_without_rendering()
    height = style.small_pt * figure.dpi / 72 * 1.12
    for ax, ends in panels:
        merged = {}
        for x, y, method in ends:
            spot = (round(float(x), 12), round(float(y), 9))
            merged.setdefault(spot, (x, y, [], style.text_colour(method)))[2].append(method)
        placed = sorted(((ax.transData.transform((x, y)), ", ".join(texts), tone)
                         for x, y, texts, tone in merged.values()), key=lambda end: end[0][1])
        ys = _moved_apart([at[1] for at, _, _ in placed], height, ax.get_window_extent())
        to_data, to_axes = ax.transData.inverted().transform, ax.transAxes.inverted().transform
        for (at, text, tone), y_text in zip(placed, ys):
            ax.annotate(text, xy=to_data(at), xytext=(1.03, to_axes((0, y_text))[1]),
                        textcoords="axes fraction", color=tone, fontsize=style.small_pt,
                        va="center", annotation_clip=False,
                        arrowprops={"arrowstyle": "-", "color": tone, "linewidth": 0.4,
                                    "alpha": 0.7, "shrinkA": 0, "shrinkB": 0,
                                    "relpos": (0, 0.5)})


def _moved_apart(ys, height, box):
    """Rising places `height` apart, as near to `ys` (rising) as may be, inside the box if it fits.

    Neighbours that would touch form a group round the middle of where its members want to be.
    """
    groups = []  # [sum of wanted starts, members]
    for y in ys:
        groups.append([y, 1])
        while len(groups) > 1 and _start(groups[-2]) + groups[-2][1] * height > _start(groups[-1]):
            wanted, members = groups.pop()
            groups[-1][0] += wanted - members * groups[-1][1] * height
            groups[-1][1] += members
    placed = [_start(group) + i * height for group in groups for i in range(group[1])]
    for i in range(1, len(placed)):
        placed[0] = max(placed[0], box.y0)
        placed[i] = max(placed[i], placed[i - 1] + height)
    over = max(0, placed[-1] - box.y1) if placed else 0
    for i in range(len(placed) - 1, -1, -1):
        limit = placed[i + 1] - height if i + 1 < len(placed) else box.y1
        placed[i] = min(placed[i], limit) if over else placed[i]
    return placed


def _start(group):
    """Where the first member of a group stands."""
    return group[0] / group[1]


class LabelPlaces:
    """Finds places for texts beside points so that texts touch neither each other nor marks."""

    _RINGS_PT = (6, 10, 15, 21, 28, 36, 46, 58, 72)

    def __init__(self, ax, style, points, bars=()):
        """points: (x, y, text) each, in data; bars: ((x0, y0), (x1, y1)) that texts should avoid."""
        self._ax, self._style = ax, style
        ax.figure.draw_without_rendering()
        self._inside = ax.get_window_extent()
        self._dots = np.array([ax.transData.transform((x, y)) for x, y, _ in points])
        self._texts = [text for _, _, text in points]
        self._bars = [np.sort(ax.transData.transform(bar), axis=0) for bar in bars]
        self._sizes = [self._size(text) for text in self._texts]
        self._boxes = [None] * len(points)

    def _size(self, text):
        probe = self._ax.text(0, 0, text, fontsize=self._style.small_pt)
        extent = probe.get_window_extent()
        probe.remove()
        return extent.width, extent.height

    def _candidates(self, i):
        (x, y), (w, h) = self._dots[i], self._sizes[i]
        for far in self._RINGS_PT:
            for turn in range(16):
                angle = 2 * math.pi * turn / 16
                cx, cy = math.cos(angle), math.sin(angle)
                # The box's nearest edge or corner lies `far` from the point in this direction.
                left = x + far * cx - (w if cx < -0.3 else 0 if cx > 0.3 else w / 2)
                low = y + far * cy - (h if cy < -0.3 else 0 if cy > 0.3 else h / 2)
                yield far, (left, low, left + w, low + h)

    def _cost(self, i, far, box):
        inside, cost = self._inside, 0.35 * far
        out = max(0, inside.x0 - box[0]) + max(0, box[2] - inside.x1) + \
            max(0, inside.y0 - box[1]) + max(0, box[3] - inside.y1)
        cost += 400 * (out > 0) + 20 * out
        for j, dot in enumerate(self._dots):
            reach = 4.5 * self._style.scale
            if (box[0] - reach < dot[0] < box[2] + reach and
                    box[1] - reach < dot[1] < box[3] + reach):
                cost += 120
        for (x0, y0), (x1, y1) in self._bars:
            if box[0] < x1 + 1 and x0 - 1 < box[2] and box[1] < y1 + 1 and y0 - 1 < box[3]:
                cost += 9
        for j, other in enumerate(self._boxes):
            if j != i and other is not None and _overlap(box, other):
                cost += 300
            if j != i and other is not None and far > 8 and _crosses(
                    self._dots[i], _anchor(box, self._dots[i]), other):
                cost += 60
        return cost

    def place(self):
        """Boxes in pixels, in the order of the points, and whether none touches another."""
        order = sorted(range(len(self._dots)), key=self._crowd, reverse=True)
        for _ in range(4):
            for i in order:
                self._boxes[i] = min(self._candidates(i),
                                     key=lambda c, i=i: self._cost(i, *c))[1]
        free = not any(_overlap(a, b) for i, a in enumerate(self._boxes)
                       for b in self._boxes[:i])
        return self._boxes, free

    def _crowd(self, i):
        away = np.hypot(*(self._dots - self._dots[i]).T)
        return np.sum(np.exp(-away / 25))

    def draw(self, tones):
        """Writes the texts in these colours; one that stands away gets a thin line to its point."""
        to_data = self._ax.transData.inverted().transform
        for dot, text, box, tone in zip(self._dots, self._texts, self._boxes, tones):
            anchor = _anchor(box, dot)
            if math.hypot(*(np.array(anchor) - dot)) > 7.5:
                ends = to_data([dot, anchor])
                self._ax.plot(ends[:, 0], ends[:, 1], color=FAINT, linewidth=0.45, zorder=2.5,
                              scalex=False, scaley=False)
            x, y = to_data(((box[0] + box[2]) / 2, (box[1] + box[3]) / 2))
            self._ax.text(x, y, text, fontsize=self._style.small_pt, color=tone, ha="center",
                          va="center", bbox=paper_box(), zorder=6)


def _overlap(a, b, gap=0.5):
    return a[0] < b[2] + gap and b[0] < a[2] + gap and a[1] < b[3] + gap and b[1] < a[3] + gap


def _anchor(box, dot):
    """Where a line from the point meets the text."""
    return (min(max(dot[0], box[0]), box[2]), min(max(dot[1], box[1] + 2), box[3] - 2))


def _crosses(a, b, box):
    for share in np.linspace(0.1, 0.9, 9):
        x, y = a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])
        if box[0] < x < box[2] and box[1] < y < box[3]:
            return True
    return False
